#pragma once

#include <vector>

#include "state.h"
#include "status.h"

namespace mass_spring {

/// A scene's first time step, the pins held where they rest, its parameters as they are.
/// @param V       #V by 3, m, row-major like all arrays that come in unchecked
/// @param E       #E by 2
/// @param m       #V, kg
/// @param pinned  #pinned
/// @param state   (result) but for derive(); undefined where the status is not ok
Status checked_scene(const std::vector<double>& V, const std::vector<int>& E,
                     const std::vector<double>& m, const std::vector<int>& pinned,
                     const Parameters& parameters, State& state);

/// Other parameters in the state of a scene.
Status checked_parameters(const Parameters& parameters, State& state);

/// Other pins.
/// @param targets  #pinned by 3, m
Status checked_pins(const std::vector<int>& pinned, const std::vector<double>& targets,
                    State& state);

/// Another pull.
/// @param pulled   #pulled
/// @param targets  #pulled by 3, m
/// @param k        N/m, 0 or more
Status checked_pull(const std::vector<int>& pulled, const std::vector<double>& targets, double k,
                    State& state);

/// Another moment.
/// @param step_number  from 1
/// @param p_curr  #V by 3, m
/// @param p_prev  #V by 3, m
Status checked_moment(int step_number, const std::vector<double>& p_curr,
                      const std::vector<double>& p_prev, State& state);

}  // namespace mass_spring
