#include "vertex_probe.h"

#include "system_product.h"

namespace mass_spring {

template <typename Matrix, typename Cholesky>
VertexProbe vertex_probe(const TimeStep& step,
                         const Precomputation<Matrix, Cholesky>& precomputation,
                         const Iterate& iterate, const Points& y, int i) {
  Points Qp;  // #V by 3, N
  system_product(step, precomputation, iterate.p, Qp);
  VertexProbe probe;
  probe.y = y.row(i);
  probe.kAtd = step.k * (precomputation.A.col(i).transpose() * iterate.d);
  for (Eigen::InnerIterator<Matrix> entry(precomputation.A, i); entry; ++entry) {
    if (entry.value() != 0) probe.springs.push_back(static_cast<int>(entry.row()));
  }
  probe.shares.resize(static_cast<int>(probe.springs.size()), 3);
  for (int s = 0; s < probe.shares.rows(); ++s) {
    const int e = probe.springs[s];
    probe.shares.row(s) =
        step.E(e, 0) == i ? step.k * iterate.d.row(e) : -step.k * iterate.d.row(e);
  }
  probe.b = probe.kAtd + probe.y;
  probe.Qp = Qp.row(i);
  return probe;
}

template VertexProbe vertex_probe(const TimeStep&, const DensePrecomputation&, const Iterate&,
                                  const Points&, int);
template VertexProbe vertex_probe(const TimeStep&, const SparsePrecomputation&, const Iterate&,
                                  const Points&, int);

}  // namespace mass_spring
