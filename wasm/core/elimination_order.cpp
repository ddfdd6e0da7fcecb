#include "elimination_order.h"

#include "minimum_degree.h"
#include "nested_dissection.h"

namespace mass_spring {

EliminationOrder elimination_order(const Points& V, const Graph& graph) {
  EliminationOrder by_degree, by_dissection;
  by_degree.order = minimum_degree(graph);
  by_degree.tree = elimination_tree(graph, by_degree.order);
  by_dissection.order = nested_dissection(V, graph);
  by_dissection.tree = elimination_tree(graph, by_dissection.order);
  return by_dissection.tree.nonzeros < by_degree.tree.nonzeros ? by_dissection : by_degree;
}

}  // namespace mass_spring
