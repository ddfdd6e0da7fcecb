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
import selectionMatrix from '../../../../wasm/core/selection_matrix.cpp?raw';
import signedIncidenceMatrix from '../../../../wasm/core/signed_incidence_matrix.cpp?raw';
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
  'selection_matrix.cpp': selectionMatrix,
  'signed_incidence_matrix.cpp': signedIncidenceMatrix,
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

const symbolWithCode = new Map(symbolIds.map((id) => [symbol(id).code, id]));

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
