#include "inertial_prediction.h"

namespace mass_spring {

Points inertial_prediction(const TimeStep& step) {
  const Vector mobility = (step.delta_t * step.delta_t) * step.m.cwiseInverse();  // #V, m/N
  return 2 * step.p_curr - step.p_prev + mobility.asDiagonal() * step.f_ext;
}

}  // namespace mass_spring
