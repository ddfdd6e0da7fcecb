export const en = {
  first: 'To the beginning',
  back: 'One step back',
  forward: 'One step on',
};
