/** The symbol table: the one source of what equations, legends, matrices, code, plots and cards say about a symbol. */

import type { SectionId } from './sections.ts';

/** Custom properties of colours.css. The seven symbols that meet in the two equations have a colour each, the rest share one. Arms and springs meet nowhere: their symbols take the same colours. */
export type ColourToken = `--symbol-${'p' | 'd' | 'r' | 'k' | 'Q' | 'b' | 'y' | 'other'}`;

/** What rows or columns are counted by: springs, vertices, pins, a spring's two ends, x, y and z, or those of all vertices or of all but the pins; of an arm its joints, its links, a quaternion's numbers, or x, y and z of all joints that turn a link. */
export type Axis = '#E' | '#V' | '#pinned' | '2' | '3' | '3#V' | '3#free' | '#joints' | '#links' | '4' | '3#links';

export interface NotationSymbol {
  tex: string;
  /** Its name in C++, TypeScript and JSON. */
  code: string;
  /** Rows, then columns; empty for a single number. */
  shape: readonly [] | readonly [Axis] | readonly [Axis, Axis];
  /** SI unit; null when dimensionless. */
  unit: string | null;
  colour: ColourToken;
  /** Where the lesson introduces it; null: the lesson, which is about springs, does not. */
  section: SectionId | null;
  /** TeX of what it equals, in the macros of macros.ts, where an equation says it best. */
  definition?: string;
}

const { raw } = String;

/** Ids are letters only, because TeX command names are. */
export const symbols = {
  vertexCount: {
    tex: raw`\#V`,
    code: 'vertexCount',
    shape: [],
    unit: null,
    colour: '--symbol-other',
    section: 'model',
  },
  springCount: {
    tex: raw`\#E`,
    code: 'springCount',
    shape: [],
    unit: null,
    colour: '--symbol-other',
    section: 'model',
  },
  V: { tex: raw`\mathbf{V}`, code: 'V', shape: ['#V', '3'], unit: 'm', colour: '--symbol-other', section: 'model' },
  E: { tex: raw`\mathbf{E}`, code: 'E', shape: ['#E', '2'], unit: null, colour: '--symbol-other', section: 'model' },
  r: {
    tex: 'r',
    code: 'r',
    shape: ['#E'],
    unit: 'm',
    colour: '--symbol-r',
    section: 'model',
    definition: raw`\symr_{ij} = \lVert \symV_i - \symV_j \rVert`,
  },
  m: { tex: 'm', code: 'm', shape: ['#V'], unit: 'kg', colour: '--symbol-other', section: 'model' },
  k: { tex: 'k', code: 'k', shape: [], unit: 'N/m', colour: '--symbol-k', section: 'energy' },
  deltaT: { tex: raw`\Delta t`, code: 'delta_t', shape: [], unit: 's', colour: '--symbol-other', section: 'time' },
  p: { tex: raw`\mathbf{p}`, code: 'p', shape: ['#V', '3'], unit: 'm', colour: '--symbol-p', section: 'model' },
  pCurr: {
    tex: raw`\mathbf{p}^{t}`,
    code: 'p_curr',
    shape: ['#V', '3'],
    unit: 'm',
    colour: '--symbol-other',
    section: 'time',
  },
  pPrev: {
    tex: raw`\mathbf{p}^{t-\Delta t}`,
    code: 'p_prev',
    shape: ['#V', '3'],
    unit: 'm',
    colour: '--symbol-other',
    section: 'time',
  },
  pTarget: {
    tex: raw`\mathbf{p}^{\mathrm{target}}`,
    code: 'targets',
    shape: ['#V', '3'],
    unit: 'm',
    colour: '--symbol-other',
    section: 'pins',
  },
  d: {
    tex: raw`\mathbf{d}`,
    code: 'd',
    shape: ['#E', '3'],
    unit: 'm',
    colour: '--symbol-d',
    section: 'trick',
    definition: raw`\symd_{ij} = \operatorname*{arg\,min}_{\lVert \symd \rVert = \symr_{ij}} \lVert (\symp_i - \symp_j) - \symd \rVert^2`,
  },
  v: {
    tex: raw`\mathbf{v}`,
    code: 'v',
    shape: ['#E', '3'],
    unit: 'm',
    colour: '--symbol-other',
    section: 'matrices',
    definition: raw`\symv = \symA\symp`,
  },
  A: {
    tex: raw`\mathbf{A}`,
    code: 'A',
    shape: ['#E', '#V'],
    unit: null,
    colour: '--symbol-other',
    section: 'matrices',
    definition: raw`(\symA\symp)_{ij} = \symp_i - \symp_j`,
  },
  M: {
    tex: raw`\mathbf{M}`,
    code: 'M',
    shape: ['#V', '#V'],
    unit: 'kg',
    colour: '--symbol-other',
    section: 'matrices',
    definition: raw`\symM_{ii} = \symm_i`,
  },
  C: {
    tex: raw`\mathbf{C}`,
    code: 'C',
    shape: ['#pinned', '#V'],
    unit: null,
    colour: '--symbol-other',
    section: 'pins',
  },
  w: { tex: 'w', code: 'w', shape: [], unit: 'N/m', colour: '--symbol-other', section: 'pins' },
  Q: {
    tex: raw`\mathbf{Q}`,
    code: 'Q',
    shape: ['#V', '#V'],
    unit: 'N/m',
    colour: '--symbol-Q',
    section: 'matrices',
    definition: raw`\symQ = \symk\symA^{\mathrm T}\symA + \symM/\symdeltaT^2 + \symw\symC^{\mathrm T}\symC`,
  },
  y: { tex: raw`\mathbf{y}`, code: 'y', shape: ['#V', '3'], unit: 'N', colour: '--symbol-y', section: 'matrices' },
  b: {
    tex: raw`\mathbf{b}`,
    code: 'b',
    shape: ['#V', '3'],
    unit: 'N',
    colour: '--symbol-b',
    section: 'matrices',
    definition: raw`\symb = \symk\symA^{\mathrm T}\symd + \symy`,
  },
  L: {
    tex: raw`\mathbf{L}`,
    code: 'L',
    shape: ['#V', '#V'],
    unit: '√(N/m)',
    colour: '--symbol-other',
    section: 'solving',
    definition: raw`\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}`,
  },
  P: {
    tex: raw`\mathbf{P}`,
    code: 'P',
    shape: ['#V', '#V'],
    unit: null,
    colour: '--symbol-other',
    section: 'solving',
    definition: raw`\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}`,
  },
  K: {
    tex: raw`\mathbf{K}`,
    code: 'K',
    shape: ['3#V', '3#V'],
    unit: 'N/m',
    colour: '--symbol-other',
    section: 'energy',
    definition: raw`\symK = -\,\partial^2\sympotential / \partial\symp^2`,
  },
  Phat: {
    tex: raw`\hat{\mathbf{P}}`,
    code: 'fixed_point_constraints',
    shape: ['3#free', '3#V'],
    unit: null,
    colour: '--symbol-other',
    section: 'pins',
  },
  fExt: {
    tex: raw`\mathbf{f}^{\mathrm{ext}}`,
    code: 'f_ext',
    shape: ['#V', '3'],
    unit: 'N',
    colour: '--symbol-other',
    section: 'model',
  },
  g: { tex: raw`\mathbf{g}`, code: 'g', shape: ['3'], unit: 'm/s²', colour: '--symbol-other', section: 'model' },
  a: { tex: raw`\mathbf{a}`, code: 'a', shape: ['#V', '3'], unit: 'm/s²', colour: '--symbol-other', section: 'model' },
  f: {
    tex: raw`\mathbf{f}`,
    code: 'f',
    shape: ['#V', '3'],
    unit: 'N',
    colour: '--symbol-other',
    section: 'model',
    definition: raw`\symf = \symM\syma`,
  },
  velocity: {
    tex: raw`\dot{\mathbf{p}}`,
    code: 'velocity',
    shape: ['#V', '3'],
    unit: 'm/s',
    colour: '--symbol-other',
    section: 'time',
    definition: raw`\symvelocity \approx (\sympCurr - \sympPrev)/\symdeltaT`,
  },
  objective: {
    tex: raw`E(\mathbf{p})`,
    code: 'objective',
    shape: [],
    unit: 'J',
    colour: '--symbol-other',
    section: 'optimisation',
  },
  potential: {
    tex: raw`E_{\mathrm{pot}}(\mathbf{p})`,
    code: 'potential',
    shape: [],
    unit: 'J',
    colour: '--symbol-other',
    section: 'energy',
    definition: raw`\sympotential = \textstyle\sum_{ij} \tfrac{1}{2}\symk\,(\lVert \symp_i - \symp_j \rVert - \symr_{ij})^2`,
  },
  inertia: {
    tex: raw`E_{\mathrm{in}}(\mathbf{p})`,
    code: 'inertia',
    shape: [],
    unit: 'J',
    colour: '--symbol-other',
    section: 'optimisation',
    definition: raw`\syminertia = \tfrac{1}{2\symdeltaT^2} \textstyle\sum_i \symm_i \lVert \symp_i - 2\sympCurr_i + \sympPrev_i \rVert^2`,
  },
  external: {
    tex: raw`E_{\mathrm{ext}}(\mathbf{p})`,
    code: 'external',
    shape: [],
    unit: 'J',
    colour: '--symbol-other',
    section: 'optimisation',
    definition: raw`\symexternal = -\textstyle\sum_i \symp_i^{\mathrm T} \symfExt_i`,
  },
  pinEnergy: {
    tex: raw`E_{\mathrm{pin}}(\mathbf{p})`,
    code: 'pin',
    shape: [],
    unit: 'J',
    colour: '--symbol-other',
    section: 'pins',
    definition: raw`\sympinEnergy = \tfrac{1}{2}\symw \textstyle\sum_i \lVert \symp_i - \sympTarget_i \rVert^2`,
  },
  gradient: {
    tex: raw`\nabla E(\mathbf{p})`,
    code: 'gradient',
    shape: ['#V', '3'],
    unit: 'N',
    colour: '--symbol-other',
    section: 'optimisation',
  },
  surrogate: {
    tex: raw`\tilde{E}(\mathbf{p},\mathbf{d})`,
    code: 'surrogate',
    shape: [],
    unit: 'J',
    colour: '--symbol-other',
    section: 'trick',
    definition: raw`\symobjective = \min_{\symd} \symsurrogate`,
  },
  kappa: {
    tex: raw`\kappa`,
    code: 'stiffnessNumber',
    shape: [],
    unit: null,
    colour: '--symbol-other',
    section: 'trick',
    definition: raw`\symkappa = \max_i \tfrac{\symdeltaT^2}{\symm_i} \textstyle\sum_j \symk_{ij}`,
  },
  x: {
    tex: raw`\mathbf{x}`,
    code: 'x',
    shape: ['#joints', '3'],
    unit: 'm',
    colour: '--symbol-p',
    section: null,
    definition: raw`\symx_i = \symx_{i-1} + \symR_{i-1}\symo_i`,
  },
  o: { tex: raw`\mathbf{o}`, code: 'offsets', shape: ['#links', '3'], unit: 'm', colour: '--symbol-r', section: null },
  q: { tex: raw`\mathbf{q}`, code: 'q', shape: ['#joints', '4'], unit: null, colour: '--symbol-d', section: null },
  R: {
    tex: raw`\mathbf{R}`,
    code: 'R',
    shape: ['3', '3'],
    unit: null,
    colour: '--symbol-k',
    section: null,
    definition: raw`\symR_i = \symR_{i-1}\symq_i`,
  },
  xTarget: {
    tex: raw`\mathbf{x}^{*}`,
    code: 'target',
    shape: ['3'],
    unit: 'm',
    colour: '--symbol-y',
    section: null,
  },
  toEffector: {
    tex: raw`\mathbf{s}`,
    code: 'ray',
    shape: ['3'],
    unit: 'm',
    colour: '--symbol-other',
    section: null,
    definition: raw`\symtoEffector_i = \symx_n - \symx_i`,
  },
  toTarget: {
    tex: raw`\mathbf{t}`,
    code: 'wanted',
    shape: ['3'],
    unit: 'm',
    colour: '--symbol-other',
    section: null,
    definition: raw`\symtoTarget_i = \symxTarget - \symx_i`,
  },
  theta: {
    tex: raw`\theta`,
    code: 'angle',
    shape: [],
    unit: 'rad',
    colour: '--symbol-b',
    section: null,
    definition: raw`\symtheta_i = \operatorname{atan2}(\lVert \symtoEffector_i \times \symtoTarget_i \rVert,\; \symtoEffector_i \cdot \symtoTarget_i)`,
  },
  missing: {
    tex: raw`\mathbf{e}`,
    code: 'missing',
    shape: ['3'],
    unit: 'm',
    colour: '--symbol-other',
    section: null,
    definition: raw`\symmissing = \symxTarget - \symx_n`,
  },
  J: {
    tex: raw`\mathbf{J}`,
    code: 'J',
    shape: ['3', '3#links'],
    unit: 'm',
    colour: '--symbol-Q',
    section: null,
    definition: raw`\symJ = \partial\symx_n / \partial\symturn`,
  },
  turn: {
    tex: raw`\boldsymbol{\Delta}`,
    code: 'turn',
    shape: ['3#links'],
    unit: 'rad',
    colour: '--symbol-d',
    section: null,
  },
  lambda: {
    tex: raw`\lambda`,
    code: 'damping',
    shape: [],
    unit: 'm',
    colour: '--symbol-other',
    section: null,
  },
  epsilon: { tex: raw`\varepsilon`, code: 'epsilon', shape: [], unit: 'm', colour: '--symbol-other', section: null },
} as const satisfies Record<string, NotationSymbol>;

export type SymbolId = keyof typeof symbols;

export const symbolIds = Object.keys(symbols) as SymbolId[];

export type Thing = 'spring' | 'vertex';

const counted: Record<Axis, Thing | null> = {
  '#E': 'spring',
  '#V': 'vertex',
  '#pinned': 'vertex',
  '2': null,
  '3': null,
  '3#V': 'vertex',
  '3#free': 'vertex',
  '#joints': null,
  '#links': null,
  '4': null,
  '3#links': null,
};

/** What each row or column along an axis belongs to, if to any one thing. */
export function thingAlong(axis: Axis): Thing | null {
  return counted[axis];
}

/** Whether the symbol has a row or column for every such thing. */
export function isAbout(id: SymbolId, thing: Thing): boolean {
  return symbol(id).shape.some((axis) => thingAlong(axis) === thing);
}

/** The entry as the general type (the table itself is kept literal for its keys). */
export function symbol(id: SymbolId): NotationSymbol {
  return symbols[id];
}

export function isSymbolId(text: string): text is SymbolId {
  return Object.hasOwn(symbols, text);
}
