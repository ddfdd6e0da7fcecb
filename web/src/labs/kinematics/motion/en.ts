/** How the arm draws, told in words. */
export const en = {
  label: 'Drawing',
  play: 'Draw',
  pause: 'Pause',
  back: 'Previous target',
  forward: 'Next target',
  reset: 'To the first target',
  target: 'Target of the drawing',
  place: 'target {{place}} of {{count}}',
  air: 'pen lifted',
  errors: {
    heading: 'How far from each target',
    label: 'distance from end effector to target, mm',
    target: 'target',
    error: 'distance',
    within: 'ε, near enough',
    summary:
      'The distance between end effector and target for each of {{count}} targets: {{worst}} at most, at target {{at}}. Near enough is {{epsilon}}.',
    said: '{{worst}} at most, at target {{at}}; {{missed}} of {{count}} targets are further off than ε = {{epsilon}}. {{iterations}} iterations at most for one target.',
  },
};
