/** Of the formulas' own faces, those that stand in running text and in most displays. */
const faces = ['1em KaTeX_Main', 'bold 1em KaTeX_Main', 'italic 1em KaTeX_Math', '1em KaTeX_Size1', '1em KaTeX_Size2'];

/** ms: then a text is better read with formulas that still move than not at all. */
const patience = 1000;

/** Resolves once formulas have their final sizes, so that no line of a text moves when they come. */
export async function formulaFonts(): Promise<void> {
  const loaded = Promise.allSettled(faces.map((face) => document.fonts.load(face)));
  await Promise.race([loaded, new Promise((resolve) => setTimeout(resolve, patience))]);
}
