const { raw } = String;

/** TeX in the macros of notation/macros.ts. Each formula wraps as a whole on narrow screens. */
export const kinematicsFormulas = {
  forward: [raw`\symR_i = \symR_{i-1}\,\symq_i`, raw`\symx_i = \symx_{i-1} + \symR_{i-1}\,\symo_i`],
  rays: [raw`\symtoEffector_i = \symx_n - \symx_i`, raw`\symtoTarget_i = \symxTarget - \symx_i`],
  angle: [
    raw`\symtheta_i = \operatorname{atan2}\bigl(\lVert \symtoEffector_i \times \symtoTarget_i \rVert,\; \symtoEffector_i \cdot \symtoTarget_i\bigr)`,
  ],
  turn: [
    raw`\symq_i \leftarrow \symq_i\,\operatorname{rot}\bigl(\symtheta_i,\; \symR_i^{\mathrm T}(\symtoEffector_i \times \symtoTarget_i)\bigr)`,
  ],
  backward: [
    raw`\symx_n \leftarrow \symxTarget`,
    raw`\symx_i \leftarrow \symx_{i+1} + \lVert \symo_{i+1} \rVert\,\frac{\symx_i - \symx_{i+1}}{\lVert \symx_i - \symx_{i+1} \rVert}`,
  ],
  forwardPass: [
    raw`\symx_0 \leftarrow \symx_{\mathrm{root}}`,
    raw`\symx_{i+1} \leftarrow \symx_i + \lVert \symo_{i+1} \rVert\,\frac{\symx_{i+1} - \symx_i}{\lVert \symx_{i+1} - \symx_i \rVert}`,
  ],
  rotations: [raw`\symR_i\,\symo_{i+1} = \symx_{i+1} - \symx_i`],
  jacobian: [
    raw`\symJ_i = \bigl(\hat x \times \symtoEffector_i,\; \hat y \times \symtoEffector_i,\; \hat z \times \symtoEffector_i\bigr)`,
  ],
  leastSquares: [
    raw`\symmissing = \symxTarget - \symx_n`,
    raw`\symturn = \symJ^{\mathrm T}\bigl(\symJ\symJ^{\mathrm T} + \symlambda^2\mathbf{I}\bigr)^{-1}\symmissing`,
  ],
} as const satisfies Record<string, readonly string[]>;

/** Forward kinematics of joint i, with numbers for its indices. */
export function forwardOf(i: number): string {
  if (i === 0) return raw`\symx_0 = \symx_{\mathrm{root}}, \quad \symR_0 = \symq_0`;
  return raw`\symx_{${i}} = \symx_{${i - 1}} + \symR_{${i - 1}}\,\symo_{${i}}, \quad \symR_{${i}} = \symR_{${i - 1}}\,\symq_{${i}}`;
}
