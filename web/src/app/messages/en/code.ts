export const code = {
  listing: 'Source of {{file}}, line by line',
  line: 'Line {{number}}: {{line}}',
  fold: 'In code',
  plain: 'The functions as one would write them down. The fast path computes the same iterates.',
};
