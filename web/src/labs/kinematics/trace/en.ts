/** Texts of the search's trace. */
export const en = {
  label: 'Steps of the search',
  first: 'To the beginning of the search',
  iterationBack: 'One iteration back',
  back: 'One step back',
  forward: 'One step on',
  iterationForward: 'One iteration on',
  last: 'To the end of the search',
  slider: 'Step of the search',
  hang: 'From the hanging arm',
  hangHint: 'Search for the same target again, from an arm that hangs straight down',
  iteration: 'iteration {{iteration}} of {{iterations}}',
  happened: {
    start: 'where the search begins',
    joint: 'joint {{joint}} turned',
    backward: 'backward pass',
    forward: 'forward pass',
    all: 'all joints turned',
    limit: 'held to the limits',
    straight: 'laid straight towards the target',
    bend: 'bent a little to begin with',
  },
};
