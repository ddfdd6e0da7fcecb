export const equations = {};
