export const code = {
  listing: 'Source of {{file}}, line by line',
  line: 'Line {{number}}: {{line}}',
  fold: 'in code',
};
