export const plots = {};
