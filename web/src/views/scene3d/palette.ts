/** Colours of the 3D views, all "#rrggbb". Hues are Okabe and Ito's, which survive colour blindness. */
export interface Palette {
  background: string;
  grid: string;
  /** Springs of the global view, where strain is not the point. */
  spring: string;
  vertex: string;
  /** What was there before this half-step. */
  ghost: string;
  /** What this half-step moved. */
  arrow: string;
  pin: string;
  selected: string;
  /** The surface of scenes without a texture. */
  cloth: string;
  strain: StrainScale;
}

/** A diverging scale: shorter than at rest, at rest, longer than at rest. */
export interface StrainScale {
  compressed: string;
  neutral: string;
  stretched: string;
}

export const lightPalette: Palette = {
  background: '#ffffff',
  grid: '#eef0f3',
  spring: '#3f4a5a',
  vertex: '#036dd7',
  ghost: '#d3d8df',
  arrow: '#009e73',
  pin: '#b0407f',
  selected: '#e69f00',
  cloth: '#dfe7ee',
  strain: { compressed: '#0072b2', neutral: '#a9b0ba', stretched: '#d55e00' },
};

export const darkPalette: Palette = {
  background: '#101318',
  grid: '#1b2027',
  spring: '#b4becb',
  vertex: '#2a95fe',
  ghost: '#39414d',
  arrow: '#2ec79b',
  pin: '#e58fc0',
  selected: '#f0b429',
  cloth: '#8494a6',
  strain: { compressed: '#56b4e9', neutral: '#707a88', stretched: '#ee7733' },
};
