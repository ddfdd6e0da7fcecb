export const symbols = {};
