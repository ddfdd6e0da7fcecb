export const page = {
  title: 'Mass–Spring Lab',
};
