import type { SectionId } from '../../../notation/sections.ts';
import type { Mistake } from '../../../solver/mistaken_simulation.ts';
import type { CodePart } from '../../../views/code/sources.ts';
import type { Measure } from './measures.ts';

const { raw } = String;

export type Shown = Exclude<Mistake, 'none'>;

export interface Card {
  mistake: Shown;
  /** A scene of the library that shows it, and scenes that do as well. */
  scene: string;
  also: readonly string[];
  /** What tells the two apart. */
  measure: Measure;
  /** Whether it leaves every scale. */
  explodes?: boolean;
  /** Whether the pins have to move for it to be seen. */
  movesPins?: boolean;
  /** TeX; what differs is boxed. */
  wrong: string;
  right: string;
  code: readonly { wrong: CodePart; right: CodePart }[];
  section: SectionId;
}

const wrongFile = 'solver_parts.cpp';
const iterate: CodePart = { file: 'right_parts.cpp', name: 'iterate' };
const inertial: CodePart = { file: 'inertial_right_hand_side.cpp', name: 'inertial_right_hand_side' };
const every = ['single-spring-horizontal', 'triangle', 'square', 'horizontal-chain', 'patch', 'net'];

export const cards: readonly Card[] = [
  {
    mistake: 'd-once',
    scene: 'single-spring-horizontal',
    also: ['triangle', 'square', 'patch', 'net'],
    measure: 'height',
    wrong: raw`\symQ\symp = \symk\symA^{\mathrm T}\,\symd(\boxed{\sympCurr}) + \symy`,
    right: raw`\symQ\symp = \symk\symA^{\mathrm T}\,\symd(\boxed{\symp}) + \symy`,
    code: [{ wrong: { file: wrongFile, name: 'project_once' }, right: iterate }],
    section: 'trick',
  },
  {
    mistake: 'k-forgotten',
    scene: 'net',
    also: [...every, 'tower'],
    measure: 'height',
    wrong: raw`\symb = \symA^{\mathrm T}\symd + \symy`,
    right: raw`\symb = \boxed{\symk}\,\symA^{\mathrm T}\symd + \symy`,
    code: [
      {
        wrong: { file: wrongFile, name: 'right_hand_side_without_k' },
        right: { file: 'right_hand_side.cpp', name: 'right_hand_side' },
      },
    ],
    section: 'matrices',
  },
  {
    mistake: 'sign-in-A',
    scene: 'net',
    also: [...every, 'tower'],
    measure: 'energy',
    wrong: raw`\symA_{ij,\,i} = +1, \quad \symA_{ij,\,j} = \boxed{+1}`,
    right: raw`\symA_{ij,\,i} = +1, \quad \symA_{ij,\,j} = \boxed{-1}`,
    code: [
      {
        wrong: { file: wrongFile, name: 'incidence_without_minus' },
        right: { file: 'signed_incidence_matrix.cpp', name: 'signed_incidence_matrix' },
      },
    ],
    section: 'matrices',
  },
  {
    mistake: 'times-swapped',
    scene: 'net',
    also: every,
    measure: 'energy',
    explodes: true,
    wrong: raw`\symy = \tfrac{1}{\symdeltaT^2}\symM\,(\boxed{2\sympPrev - \sympCurr}) + \dots`,
    right: raw`\symy = \tfrac{1}{\symdeltaT^2}\symM\,(\boxed{2\sympCurr - \sympPrev}) + \dots`,
    code: [{ wrong: { file: wrongFile, name: 'inertial_with_times_swapped' }, right: inertial }],
    section: 'time',
  },
  {
    mistake: 'rest-for-targets',
    scene: 'net',
    also: [...every, 'tower'],
    measure: 'height',
    movesPins: true,
    wrong: raw`\symy = \dots + \symfExt + \symw\symC^{\mathrm T}\symC\,\boxed{\symV}`,
    right: raw`\symy = \dots + \symfExt + \symw\symC^{\mathrm T}\symC\,\boxed{\sympTarget}`,
    code: [{ wrong: { file: wrongFile, name: 'inertial_with_rest_for_targets' }, right: inertial }],
    section: 'pins',
  },
  {
    mistake: 'pins-after-solving',
    scene: 'net',
    also: ['horizontal-chain', 'patch', 'square', 'tower'],
    measure: 'height',
    wrong: raw`\symQ = \symk\symA^{\mathrm T}\symA + \tfrac{1}{\symdeltaT^2}\symM, \qquad \symp_i \leftarrow \sympTarget_i`,
    right: raw`\symQ = \symk\symA^{\mathrm T}\symA + \tfrac{1}{\symdeltaT^2}\symM + \boxed{\symw\symC^{\mathrm T}\symC}`,
    code: [
      { wrong: { file: wrongFile, name: 'overwrite_pins_after_solving' }, right: iterate },
      { wrong: { file: wrongFile, name: 'inertial_without_pins' }, right: inertial },
    ],
    section: 'pins',
  },
  {
    mistake: 'factorised-again',
    scene: 'tower',
    also: ['net', 'horizontal-chain', 'patch'],
    measure: 'time',
    wrong: raw`\boxed{\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}}, \quad \symQ\symp = \symb, \quad \boxed{\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}}, \quad \symQ\symp = \symb, \quad \dots`,
    right: raw`\boxed{\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}}, \quad \symQ\symp = \symb, \quad \symQ\symp = \symb, \quad \dots`,
    code: [{ wrong: { file: wrongFile, name: 'factorise_every_iteration' }, right: iterate }],
    section: 'solving',
  },
  {
    mistake: 'gradient-as-force',
    scene: 'net',
    also: every,
    measure: 'height',
    wrong: raw`\symy = \tfrac{1}{\symdeltaT^2}\symM(2\sympCurr - \sympPrev) \mathbin{\boxed{-}} \symfExt + \dots`,
    right: raw`\symy = \tfrac{1}{\symdeltaT^2}\symM(2\sympCurr - \sympPrev) \mathbin{\boxed{+}} \symfExt + \dots`,
    code: [{ wrong: { file: wrongFile, name: 'inertial_with_gradient_as_force' }, right: inertial }],
    section: 'optimisation',
  },
  {
    mistake: 'stored-zeros',
    scene: 'tower',
    also: ['net'],
    measure: 'time',
    wrong: raw`\symQ: \quad \boxed{\symvertexCount^2}`,
    right: raw`\symQ: \quad \boxed{\symvertexCount + 2\,\symspringCount}`,
    code: [
      {
        wrong: { file: wrongFile, name: 'system_with_zeros' },
        right: { file: 'right_parts.cpp', name: 'system_of' },
      },
    ],
    section: 'sparse',
  },
  {
    mistake: 'one-iteration',
    scene: 'single-spring-horizontal',
    also: ['triangle', 'square', 'patch', 'net'],
    measure: 'energy',
    wrong: raw`\symp^{0} = \sympCurr \;\to\; \symp^{1}`,
    right: raw`\symp^{0} = \sympCurr \;\to\; \symp^{1} \;\to\; \dots \;\to\; \symp^{50}`,
    code: [{ wrong: { file: wrongFile, name: 'iterate_once' }, right: iterate }],
    section: 'trick',
  },
];
