#include "status.h"

namespace mass_spring {

const std::vector<std::string>& status_code_names() {
  static const std::vector<std::string> names = {
      "ok",
      "no_scene",
      "no_vertices",
      "wrong_length",
      "not_finite",
      "index_out_of_range",
      "self_spring",
      "duplicate_spring",
      "duplicate_vertex",
      "not_positive",
      "negative",
      "too_stiff",
      "too_large",
      "factorisation_failed",
      "diverged",
      "unstable",
      "on_root",
  };
  return names;
}

}  // namespace mass_spring
