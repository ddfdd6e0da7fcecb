export const en = {
  intro: 'This section is being written.',
};
