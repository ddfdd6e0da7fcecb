import denseCholesky from '../../../../wasm/core/dense_cholesky.cpp?raw';
import edgeLengths from '../../../../wasm/core/edge_lengths.cpp?raw';
import edgeVectors from '../../../../wasm/core/edge_vectors.cpp?raw';
import precomputationDense from '../../../../wasm/core/fast_mass_springs_precomputation_dense.cpp?raw';
import precomputationSparse from '../../../../wasm/core/fast_mass_springs_precomputation_sparse.cpp?raw';
import step from '../../../../wasm/core/fast_mass_springs_step.h?raw';
import globalStep from '../../../../wasm/core/global_step.cpp?raw';
import inertialRightHandSide from '../../../../wasm/core/inertial_right_hand_side.cpp?raw';
import localStep from '../../../../wasm/core/local_step.cpp?raw';
import massMatrix from '../../../../wasm/core/mass_matrix.cpp?raw';
import matrixFromTriplets from '../../../../wasm/core/matrix_from_triplets.cpp?raw';
import rightHandSide from '../../../../wasm/core/right_hand_side.cpp?raw';
import rightParts from '../../../../wasm/core/right_parts.cpp?raw';
import selectionMatrix from '../../../../wasm/core/selection_matrix.cpp?raw';
import signedIncidenceMatrix from '../../../../wasm/core/signed_incidence_matrix.cpp?raw';
import solverParts from '../../../../wasm/core/solver_parts.cpp?raw';
import sparseCholesky from '../../../../wasm/core/sparse_cholesky.cpp?raw';
import systemMatrix from '../../../../wasm/core/system_matrix.cpp?raw';
import { type SymbolId, symbol, symbolIds } from '../../notation/symbols.ts';

/** Source files of wasm/core that the page shows. */
const files = {
  'dense_cholesky.cpp': denseCholesky,
  'edge_lengths.cpp': edgeLengths,
  'edge_vectors.cpp': edgeVectors,
  'fast_mass_springs_precomputation_dense.cpp': precomputationDense,
  'fast_mass_springs_precomputation_sparse.cpp': precomputationSparse,
  'fast_mass_springs_step.h': step,
  'global_step.cpp': globalStep,
  'inertial_right_hand_side.cpp': inertialRightHandSide,
  'local_step.cpp': localStep,
  'mass_matrix.cpp': massMatrix,
  'matrix_from_triplets.cpp': matrixFromTriplets,
  'right_hand_side.cpp': rightHandSide,
  'right_parts.cpp': rightParts,
  'selection_matrix.cpp': selectionMatrix,
  'signed_incidence_matrix.cpp': signedIncidenceMatrix,
  'solver_parts.cpp': solverParts,
  'sparse_cholesky.cpp': sparseCholesky,
  'system_matrix.cpp': systemMatrix,
};
export type SourceFile = keyof typeof files;

export const sourceFiles = Object.keys(files) as SourceFile[];

/** What stands in the file's namespace, line by line, without the instantiations of templates at its end. */
export function linesOf(file: SourceFile): string[] {
  const [, body] = files[file].split(/^.*namespace mass_spring.*$/m);
  const [definitions] = body.split(/^template void/m);
  return definitions.trim().split('\n');
}

/** A function in a file. */
export interface CodePart {
  file: SourceFile;
  name: string;
}

/** Lines `first` to before `end` of linesOf(file): the function with what is said about it above. */
export function rangeOfPart({ file, name }: CodePart): { first: number; end: number } {
  const lines = linesOf(file);
  const head = lines.findIndex((line) => new RegExp(`^[A-Za-z].*\\b${name}\\(`).test(line));
  if (head < 0) throw new RangeError(`${file}: no function ${name}`);
  const before = lines.slice(0, head).findLastIndex((line) => !/^(\/\/|template)/.test(line));
  return { first: before + 1, end: lines.indexOf('}', head) + 1 };
}

/** Lines of one function's body that the other's lacks; none where no statement is the same, and to mark all would say nothing. */
export function linesMissingIn(other: CodePart, part: CodePart): ReadonlySet<number> {
  const theirs = new Set(bodyOf(other).map(({ line }) => line));
  const mine = bodyOf(part);
  if (!mine.some(({ line }) => line.endsWith(';') && theirs.has(line))) return new Set();
  return new Set(mine.flatMap(({ line, at }) => (theirs.has(line) ? [] : [at])));
}

/** Without its head, which names and parameters make another anyway. */
function bodyOf(part: CodePart): { line: string; at: number }[] {
  const { first, end } = rangeOfPart(part);
  const lines = linesOf(part.file);
  const head = lines.findIndex((line, at) => at >= first && line.endsWith('{'));
  return lines.slice(head + 1, end - 1).map((line, at) => ({ line, at: head + 1 + at }));
}

/** The files are about what the lesson is about. */
const symbolWithCode = new Map(
  symbolIds.filter((id) => symbol(id).section !== null).map((id) => [symbol(id).code, id]),
);

/** Symbols that have another name in a file than in the symbol table. */
const otherNames: Partial<Record<SourceFile, Readonly<Record<string, SymbolId>>>> = {
  'dense_cholesky.cpp': { L_: 'L' },
  'edge_lengths.cpp': { x: 'v' },
  'edge_vectors.cpp': { x: 'v' },
  'sparse_cholesky.cpp': { Q_: 'Q', matrixL: 'L', matrixU: 'L', permutationP: 'P', permutationPinv: 'P' },
};

/** The symbol that a name in a file stands for, if any. */
export function symbolNamed(name: string, file: SourceFile): SymbolId | undefined {
  return otherNames[file]?.[name] ?? symbolWithCode.get(name);
}
