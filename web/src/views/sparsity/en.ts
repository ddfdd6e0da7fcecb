export const en = {
  role: 'matrix',
  closer: 'Nearer',
  farther: 'Farther',
  fit: 'Show all of the matrix',
  keys: 'Arrow keys go from entry to entry, with Shift from cell to cell; Page Up and Page Down from row to row; plus, minus and 0 zoom; Enter selects.',
  invite: 'Point at an entry. Ctrl and wheel or two fingers zoom, dragging moves.',
};
