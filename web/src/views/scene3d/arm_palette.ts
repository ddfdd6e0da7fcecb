/** Colours of the arm's picture, all "#rrggbb". Blue is what is wanted, orange what the arm does, green what has turned just now. */
export interface ArmPalette {
  background: string;
  link: string;
  joint: string;
  mount: string;
  grid: string;
  axis: string;
  ghost: string;
  /** The target, and the points of the curve. */
  target: string;
  /** The end effector and the line it leaves. */
  effector: string;
  turned: string;
  /** What is under the pointer, and the glow around it. */
  pointed: string;
  glow: string;
}

export const lightArmPalette: ArmPalette = {
  background: '#ffffff',
  link: '#aeb8c4',
  joint: '#4b5768',
  mount: '#c9d0d8',
  grid: '#dfe4ea',
  axis: '#b3bcc7',
  ghost: '#c3cad3',
  target: '#0b5fbf',
  effector: '#d55e00',
  turned: '#009e73',
  pointed: '#141a22',
  glow: '#ffd60a',
};

export const darkArmPalette: ArmPalette = {
  background: '#101318',
  link: '#76828f',
  joint: '#b9c3cf',
  mount: '#3d4651',
  grid: '#232a33',
  axis: '#46505d',
  ghost: '#444e5b',
  target: '#6cb2ff',
  effector: '#ff8b3d',
  turned: '#2ec79b',
  pointed: '#ffffff',
  glow: '#b98900',
};
