/** The words of a Medit file one after the other: what stands between white space, without comments. */
export class MeshWords {
  /** Of the word last read, counted from 1; of the last line at the end. */
  line = 0;
  private readonly lines: string[];
  private row: string[] = [];
  private place = 0;

  constructor(text: string) {
    this.lines = text.split('\n');
  }

  /** Null at the end. */
  next(): string | null {
    const word = this.peek();
    this.place++;
    return word;
  }

  /** What `next` will read. */
  peek(): string | null {
    while (this.place >= this.row.length) {
      if (this.line >= this.lines.length) return null;
      const statement = this.lines[this.line++].replace(/#.*/, '').trim();
      this.row = statement === '' ? [] : statement.split(/\s+/);
      this.place = 0;
    }
    return this.row[this.place];
  }
}

/** Whether a word names a section, as far as its looks say: every name begins with a letter, and no number does. */
export function isName(word: string): boolean {
  return /^[A-Za-z]/.test(word);
}
