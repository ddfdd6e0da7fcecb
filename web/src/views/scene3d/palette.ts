/** Colours of the 3D views, all "#rrggbb". Hues are Okabe and Ito's, which survive colour blindness. */
export interface Palette {
  background: string;
  /** Springs of the global view, where strain is not the point. */
  spring: string;
  vertex: string;
  /** What was there before this half-step. */
  ghost: string;
  /** What this half-step moved. */
  arrow: string;
  pin: string;
  /** What the reader pulls at, and the pull: the page's accent. */
  pull: string;
  /** What is selected, or under the pointer, and the glow around it. */
  selected: string;
  glow: string;
  /** The surface of scenes without a texture. */
  cloth: string;
  strain: StrainScale;
}

/** A diverging scale in equal strides: much shorter than at rest, shorter, at rest, longer, much longer. */
export type StrainScale = readonly [string, string, string, string, string];

export const lightPalette: Palette = {
  background: '#ffffff',
  spring: '#4b5768',
  vertex: '#036dd7',
  ghost: '#d3d8df',
  arrow: '#009e73',
  pin: '#b0407f',
  pull: '#0b5fbf',
  selected: '#141a22',
  glow: '#ffd60a',
  cloth: '#dfe7ee',
  strain: ['#0072b2', '#56b4e9', '#99a2ae', '#e69f00', '#d55e00'],
};

export const darkPalette: Palette = {
  background: '#101318',
  spring: '#97a3b3',
  vertex: '#2a95fe',
  ghost: '#39414d',
  arrow: '#2ec79b',
  pin: '#e58fc0',
  pull: '#6cb2ff',
  selected: '#ffffff',
  glow: '#b98900',
  cloth: '#8494a6',
  strain: ['#6cc5ff', '#4a94cb', '#7a8593', '#d9a032', '#ff8b3d'],
};
