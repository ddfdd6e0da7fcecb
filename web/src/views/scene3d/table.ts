import { DataTexture, FloatType, RGBAFormat, RGBFormat, RGFormat } from 'three';

const formats = { 2: [RGFormat, 'RG32F'], 3: [RGBFormat, 'RGB32F'], 4: [RGBAFormat, 'RGBA32F'] } as const;

const rowsPerLine = 1024;

/** Rows of a few numbers in a texture, from which vertex shaders take those they need. Single precision: whole numbers are exact below 2²⁴. */
export class Table {
  /** For the uniforms of every shader that reads the table. */
  readonly uniform: { value: DataTexture };
  private readonly columns: keyof typeof formats;
  private numbers = new Float32Array();

  constructor(columns: keyof typeof formats) {
    this.columns = columns;
    this.uniform = { value: this.allocate(1) };
  }

  /** Replaces all rows; #×columns. */
  set(rows: ArrayLike<number>): void {
    this.write(rows.length / this.columns).set(rows);
  }

  /** The numbers of `count` rows, for the caller to write before the next picture. */
  write(count: number): Float32Array {
    const lines = Math.max(1, Math.ceil(count / rowsPerLine));
    if (lines !== this.uniform.value.image.height) {
      this.uniform.value.dispose();
      this.uniform.value = this.allocate(lines);
    }
    this.uniform.value.needsUpdate = true;
    return this.numbers.subarray(0, this.columns * count);
  }

  dispose(): void {
    this.uniform.value.dispose();
  }

  private allocate(lines: number): DataTexture {
    const [format, internalFormat] = formats[this.columns];
    this.numbers = new Float32Array(this.columns * rowsPerLine * lines);
    const texture = new DataTexture(this.numbers, rowsPerLine, lines, format, FloatType);
    texture.internalFormat = internalFormat; // three.js finds none by itself for three floats
    return texture;
  }
}

export const readTable = /* glsl */ `
  vec4 row(sampler2D table, int index) {
    return texelFetch(table, ivec2(index % ${rowsPerLine}, index / ${rowsPerLine}), 0);
  }
`;
