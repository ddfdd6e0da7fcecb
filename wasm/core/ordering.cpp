#include "ordering.h"

#include <algorithm>
#include <numeric>

#include "matrix_in_order.h"
#include "minimum_degree.h"

namespace mass_spring {

const std::vector<std::string>& ordering_names() {
  static const std::vector<std::string> names = {"natural", "minimum-degree", "solver"};
  return names;
}

std::vector<int> ordered_unknowns(Ordering ordering, const Triplets& Q, std::vector<int> solvers) {
  if (ordering == Ordering::solver) return solvers;
  std::vector<int> unknowns = std::move(solvers);
  std::sort(unknowns.begin(), unknowns.end());
  if (ordering == Ordering::natural) return unknowns;
  std::vector<int> numbering(unknowns.size());
  std::iota(numbering.begin(), numbering.end(), 0);
  std::vector<int> order =
      minimum_degree(graph_from_matrix(matrix_in_order(Q, unknowns)), numbering);
  for (int& unknown : order) unknown = unknowns[unknown];
  return order;
}

}  // namespace mass_spring
