/** CSS pixels; x to the right and y down, from whatever corner the user of the type says. */
export interface Rectangle {
  x: number;
  y: number;
  width: number;
  height: number;
}
