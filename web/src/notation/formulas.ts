const { raw } = String;

/** What functions of wasm/core compute: TeX in the macros of macros.ts. Each formula wraps as a whole on narrow screens. */
export const formulas = {
  edge_vectors: [raw`\symv_{ij} = \symp_i - \symp_j`],
  edge_lengths: [raw`\symr_{ij} = \lVert \symV_i - \symV_j \rVert`],
  mass_matrix: [raw`\symM_{ii} = \symm_i`],
  signed_incidence_matrix: [raw`\symA_{ij,\,i} = +1`, raw`\symA_{ij,\,j} = -1`],
  selection_matrix: [raw`(\symC\symp)_c = \symp_{i_c}`],
  system_matrix: [raw`\symQ = \symk\symA^{\mathrm T}\symA + \frac{\symM}{\symdeltaT^2} + \symw\symC^{\mathrm T}\symC`],
  dense_cholesky: [raw`\symQ = \symL\symL^{\mathrm T}`],
  sparse_cholesky: [raw`\symP\symQ\symP^{\mathrm T} = \symL\symL^{\mathrm T}`],
  local_step: [raw`\symd_{ij} = \symr_{ij}\,\frac{\symp_i - \symp_j}{\lVert \symp_i - \symp_j \rVert}`],
  global_step: [raw`\symQ\symp = \symb`],
  right_hand_side: [raw`\symb = \symk\symA^{\mathrm T}\symd + \symy`],
  inertial_right_hand_side: [
    raw`\symy = \frac{\symM\,(2\sympCurr - \sympPrev)}{\symdeltaT^2} + \symfExt + \symw\symC^{\mathrm T}\symC\,\sympTarget`,
  ],
} as const satisfies Record<string, readonly string[]>;
