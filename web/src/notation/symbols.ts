/** The symbol table: the one source of what equations, legends, matrices, plots and cards say about a symbol. */

/** Custom properties of colours.css. The seven symbols that meet in the two equations have a colour each, the rest share one. */
export type ColourToken = `--symbol-${'p' | 'd' | 'r' | 'k' | 'Q' | 'b' | 'y' | 'other'}`;

/** Where the symbol is introduced: a section of the course text on mass-spring systems, the paper it follows, or this lab. */
export type Section = 'springs' | 'energy' | 'localGlobal' | 'matrices' | 'solve' | 'pins' | 'lab';

export interface NotationSymbol {
  tex: string;
  /** Its name in C++, TypeScript and JSON. */
  code: string;
  /** Rows × columns in #V, #E and #pinned; null for a single number. */
  shape: string | null;
  /** SI unit; null when dimensionless. */
  unit: string | null;
  colour: ColourToken;
  section: Section;
  /** TeX of what it equals, in the macros of macros.ts, where an equation says it best. */
  definition?: string;
}

const { raw } = String;

/** Ids are letters only, because TeX command names are. */
export const symbols = {
  vertexCount: {
    tex: raw`\#V`,
    code: 'vertexCount',
    shape: null,
    unit: null,
    colour: '--symbol-other',
    section: 'matrices',
  },
  springCount: {
    tex: raw`\#E`,
    code: 'springCount',
    shape: null,
    unit: null,
    colour: '--symbol-other',
    section: 'matrices',
  },
  V: { tex: raw`\mathbf{V}`, code: 'V', shape: '#V × 3', unit: 'm', colour: '--symbol-other', section: 'springs' },
  E: { tex: raw`\mathbf{E}`, code: 'E', shape: '#E × 2', unit: null, colour: '--symbol-other', section: 'springs' },
  r: {
    tex: 'r',
    code: 'r',
    shape: '#E',
    unit: 'm',
    colour: '--symbol-r',
    section: 'springs',
    definition: raw`\symr_{ij} = \lVert \symV_i - \symV_j \rVert`,
  },
  m: { tex: 'm', code: 'm', shape: '#V', unit: 'kg', colour: '--symbol-other', section: 'springs' },
  k: { tex: 'k', code: 'k', shape: null, unit: 'N/m', colour: '--symbol-k', section: 'springs' },
  deltaT: { tex: raw`\Delta t`, code: 'delta_t', shape: null, unit: 's', colour: '--symbol-other', section: 'springs' },
  p: { tex: raw`\mathbf{p}`, code: 'p', shape: '#V × 3', unit: 'm', colour: '--symbol-p', section: 'springs' },
  pCurr: {
    tex: raw`\mathbf{p}^{t}`,
    code: 'p_curr',
    shape: '#V × 3',
    unit: 'm',
    colour: '--symbol-other',
    section: 'springs',
  },
  pPrev: {
    tex: raw`\mathbf{p}^{t-\Delta t}`,
    code: 'p_prev',
    shape: '#V × 3',
    unit: 'm',
    colour: '--symbol-other',
    section: 'springs',
  },
  pTarget: {
    tex: raw`\mathbf{p}^{\mathrm{target}}`,
    code: 'targets',
    shape: '#V × 3',
    unit: 'm',
    colour: '--symbol-other',
    section: 'pins',
  },
  d: {
    tex: raw`\mathbf{d}`,
    code: 'd',
    shape: '#E × 3',
    unit: 'm',
    colour: '--symbol-d',
    section: 'localGlobal',
    definition: raw`\symd_{ij} = \operatorname*{arg\,min}_{\lVert \symd \rVert = \symr_{ij}} \lVert (\symp_i - \symp_j) - \symd \rVert^2`,
  },
  A: {
    tex: raw`\mathbf{A}`,
    code: 'A',
    shape: '#E × #V',
    unit: null,
    colour: '--symbol-other',
    section: 'matrices',
    definition: raw`(\symA\symp)_{ij} = \symp_i - \symp_j`,
  },
  M: {
    tex: raw`\mathbf{M}`,
    code: 'M',
    shape: '#V × #V',
    unit: 'kg',
    colour: '--symbol-other',
    section: 'matrices',
    definition: raw`\symM_{ii} = \symm_i`,
  },
  C: { tex: raw`\mathbf{C}`, code: 'C', shape: '#pinned × #V', unit: null, colour: '--symbol-other', section: 'pins' },
  w: { tex: 'w', code: 'w', shape: null, unit: 'N/m', colour: '--symbol-other', section: 'pins' },
  Q: {
    tex: raw`\mathbf{Q}`,
    code: 'Q',
    shape: '#V × #V',
    unit: 'N/m',
    colour: '--symbol-Q',
    section: 'matrices',
    definition: raw`\symQ = \symk\symA^{\mathrm T}\symA + \symM/\symdeltaT^2 + \symw\symC^{\mathrm T}\symC`,
  },
  y: { tex: raw`\mathbf{y}`, code: 'y', shape: '#V × 3', unit: 'N', colour: '--symbol-y', section: 'matrices' },
  b: {
    tex: raw`\mathbf{b}`,
    code: 'b',
    shape: '#V × 3',
    unit: 'N',
    colour: '--symbol-b',
    section: 'matrices',
    definition: raw`\symb = \symk\symA^{\mathrm T}\symd + \symy`,
  },
  L: {
    tex: raw`\mathbf{L}`,
    code: 'L',
    shape: '#V × #V',
    unit: '√(N/m)',
    colour: '--symbol-other',
    section: 'solve',
    definition: raw`\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}`,
  },
  P: {
    tex: raw`\mathbf{P}`,
    code: 'P',
    shape: '#V × #V',
    unit: null,
    colour: '--symbol-other',
    section: 'lab',
    definition: raw`\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}`,
  },
  fExt: {
    tex: raw`\mathbf{f}^{\mathrm{ext}}`,
    code: 'f_ext',
    shape: '#V × 3',
    unit: 'N',
    colour: '--symbol-other',
    section: 'energy',
  },
  objective: {
    tex: raw`E(\mathbf{p})`,
    code: 'objective',
    shape: null,
    unit: 'J',
    colour: '--symbol-other',
    section: 'energy',
  },
  surrogate: {
    tex: raw`\tilde{E}(\mathbf{p},\mathbf{d})`,
    code: 'surrogate',
    shape: null,
    unit: 'J',
    colour: '--symbol-other',
    section: 'localGlobal',
    definition: raw`\symobjective = \min_{\symd} \symsurrogate`,
  },
  kappa: {
    tex: raw`\kappa`,
    code: 'stiffnessNumber',
    shape: null,
    unit: null,
    colour: '--symbol-other',
    section: 'lab',
    definition: raw`\symkappa = \max_i \tfrac{\symdeltaT^2}{\symm_i} \textstyle\sum_j \symk_{ij}`,
  },
} as const satisfies Record<string, NotationSymbol>;

export type SymbolId = keyof typeof symbols;

export const symbolIds = Object.keys(symbols) as SymbolId[];

/** The entry as the general type (the table itself is kept literal for its keys). */
export function symbol(id: SymbolId): NotationSymbol {
  return symbols[id];
}

export function isSymbolId(text: string): text is SymbolId {
  return Object.hasOwn(symbols, text);
}
