/** What the worker says of the matrices of the open problem, and of what solving Q p = b with them costs. Arrays belong to whoever asked. */

import type { Ordering, Triplets } from './module.ts';

/**
 * The matrices of mathematics, each with true values: rows of A are springs, rows of C are pins in the order in which they are listed, and all
 * other rows and columns are vertices. Every (row, column) occurs once, column by column.
 */
export interface Matrices {
  A: Triplets;
  /** kg. */
  M: Triplets;
  C: Triplets;
  /** AᵀA: on its diagonal how many springs each vertex has, −1 wherever a spring is. */
  AtA: Triplets;
  /** The three terms of Q, N/m: kAᵀA, M/Δt² and wCᵀC. */
  terms: { springs: Triplets; masses: Triplets; pins: Triplets };
  /** Their sum, N/m, of all vertices, whatever the path. */
  Q: Triplets;
  /**
   * Ascending: the vertices whose rows the running solver factorises and `elimination` eliminates. On the plain path all of them, pins weighted
   * by w; on the fast path those that are not pinned, whose rows and columns of Q know nothing of w.
   */
  unknowns: Int32Array;
}

/** Of linearly implicit Euler at the settled positions: other positions, other matrices. Coordinate c of vertex i is row 3i + c. */
export interface LinearlyImplicitMatrices {
  /** #V×3, m: the settled positions. */
  q: Float64Array;
  /** ∂f/∂q, N/m. */
  K: Triplets;
  /** Selects the coordinates of the vertices that are not pinned, in their order. */
  P: Triplets;
  /** M − Δt D − Δt² K and P (M − Δt D − Δt² K) Pᵀ, kg; D only where there is damping. */
  system: Triplets;
  constrained: Triplets;
  /** #E×9, N/m: H_e of every spring. */
  stiffness: Float64Array;
  /** #E×9, N·s/m: C nnᵀ of every dashpot; null without damping. */
  resistance: Float64Array | null;
}

/** Which order of elimination, and of which system; answered for the matrix of `Matrices.unknowns`, so that all orders are of one matrix. */
export interface Elimination {
  ordering: Ordering;
  /** P, #columns: the vertex that is eliminated first, second, … Row and column c of everything below belong to vertex order[c]. */
  order: Int32Array;
  /** The elimination tree, #columns: the row of the first non-zero below the diagonal of column c of L, or −1 at a root. parent[c] > c. */
  parent: Int32Array;
  /** #columns: the non-zeros of each column of L, its diagonal included. */
  counts: Int32Array;
  /** Of the lower triangle of Q, its diagonal included; of L, likewise; and their difference, the fill-in. */
  nonzerosOfQ: number;
  nonzeros: number;
  fill: number;
  /** Σ_c counts[c]²: square roots, divisions, multiplications and subtractions of the factorisation. [Davis 2006, section 4] */
  flops: number;
  /** Null where `flops` is above `limit`: then L is not computed, only counted. */
  factor: Factor | null;
  /** The most flops for which L is computed. */
  limit: number;
}

/** A lower triangle, column by column, rows ascending, so that the diagonal entry comes first in each column. */
export interface EliminatedEntries extends Triplets {
  /**
   * #entries: 0 for an entry of Q. Otherwise it is fill-in and this is how many columns had been eliminated when it came into being: an entry
   * stands in the matrix after c columns if and only if born ≤ c.
   */
  born: Int32Array;
}

/** L, P Q Pᵀ = L Lᵀ, N^½ m^−½. */
export interface Factor extends EliminatedEntries {
  /**
   * Wall-clock ms of one factorisation in this order, the median of a few, by the same algorithm for all orders (Eigen's SimplicialLLT); finding the order is not part
   * of it. The running solver has an algorithm of its own.
   */
  milliseconds: number;
}

export interface EliminationStepRequest {
  ordering: Ordering;
  /** 0 … #columns: how many columns are eliminated. More are refused as index_out_of_range. */
  columns: number;
}

/**
 * P Q Pᵀ with the first `columns` columns eliminated, lower triangle: those hold L, the block that remains holds its Schur complement
 * Q_22 − L_21 L_21ᵀ, which has yet to be eliminated. After all columns it is L, entry for entry; after 0, Q. Same request, same bits.
 */
export interface EliminationStep extends EliminationStepRequest {
  /** What stands in the matrix now, fill-in included, and no entry that is yet to come. */
  entries: EliminatedEntries;
}

/** One way to store the system of `Matrices.unknowns` and to solve it. Times are medians of a few runs. */
export interface StorageCost {
  /** Of Q, and of its factor L as this storage keeps them. */
  bytesOfQ: number;
  bytesOfL: number;
  /** Wall-clock ms of one factorisation; null where it was not tried. */
  factorise: number | null;
  /** Wall-clock ms of one global step's solve, forward and back for x, y and z; null where it was not tried. */
  substitute: number | null;
}

/** Both by the readable functions of the plain path, on the matrix that the running solver factorises. */
export interface StorageComparison {
  /** Unknowns: rows of the matrix. */
  n: number;
  dense: StorageCost;
  sparse: StorageCost;
  /** Dense is tried up to this n. Beyond, its times grow with n³ (factorise) and n² (substitute): that is for the reader of it to say. */
  largestDense: number;
}
