/** The texts of the arm's picture. */
export const en = {
  canvas: 'The arm, its target, and the floor that it draws on',
  hint: 'Drag the target in the picture’s plane, its shadow level with the floor, anything else to look around.',
  penHint: 'Draw on the floor: every stroke joins the curve. Hold Shift to look around.',
  grid: 'Grid {{step}}',
  draw: 'Draw on the floor',
  clear: 'Clear',
  target: 'Target at x {{x}}, y {{y}}, z {{z}} m.',
  targetKeys:
    'Arrow keys move the target as you see it, Page Up and Page Down away and nearer; with Shift ten times as far.',
  pen: 'Pen at x {{x}}, y {{y}} m, {{state}}.',
  penDown: 'on the floor',
  penUp: 'lifted',
  penKeys: 'Arrow keys move the pen, with Shift ten times as far. Space lowers or lifts it. Enter ends the drawing.',
  report: '{{place}} {{outcome}}',
  outcome: {
    CONVERGED: 'Reached; {{error}} off.',
    STALLED: 'The arm comes no nearer: {{error}} short of it.',
    UNREACHABLE: 'Out of reach: the arm ends {{error}} short of it.',
    MAX_ITERATIONS: 'Still {{error}} short after all iterations.',
  },
};
