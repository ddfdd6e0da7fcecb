#include "elimination_order.h"

#include "minimum_degree.h"
#include "nested_dissection.h"

namespace mass_spring {

EliminationOrder elimination_order(const Points& V, const Graph& graph) {
  EliminationOrder by_dissection, by_degree;
  by_dissection.order = nested_dissection(V, graph);
  by_dissection.tree = elimination_tree(graph, by_dissection.order);
  // Ties are everywhere in a regular mesh. Broken so, they cost less fill than in most scenes' own
  // numbering.
  by_degree.order = minimum_degree(graph, by_dissection.order);
  by_degree.tree = elimination_tree(graph, by_degree.order);
  return by_dissection.tree.nonzeros < by_degree.tree.nonzeros ? by_dissection : by_degree;
}

}  // namespace mass_spring
