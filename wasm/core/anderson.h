#pragma once

#include <algorithm>
#include <array>

#include "descent.h"
#include "least_squares.h"

namespace mass_spring {

/// Local/global iterations under Anderson acceleration. Yue Peng, Bailin Deng, Juyong Zhang, Fanyu
/// Geng, Wenjie Qin, Ligang Liu, "Anderson acceleration for geometry optimization and physics
/// simulation", 2018.
///
/// With the plain iterate q = p + f, f = -Q⁻¹ ∂E/∂p, and the differences Δf, Δq of the last
/// `window` iterations,
///   θ = argmin |f - Σ_j θ_j Δf_j|,   p ← q - Σ_j θ_j Δq_j,
/// if that lowers E, otherwise p ← q.
template <typename Problem>
class Anderson {
 public:
  using Field = typename Problem::Field;

  void begin(Problem& problem, const Field& p) {
    descent_.begin(problem, p);
    for (Field* field : {&f_, &q_, &f_before_, &q_before_, &residual_}) field->resizeLike(p);
    for (auto* fields : {&delta_f_, &delta_q_, &columns_}) {
      for (Field& field : *fields) field.resizeLike(p);
    }
    iterations_ = 0;
  }

  /// @param p  (updated)
  /// @return whether p changed; if not, not even the plain iteration lowers E by more than rounding
  bool iterate(Problem& problem, Field& p) {
    descent_.solve(problem, standing().gradient, f_);
    f_ = -f_;
    q_ = p + f_;
    if (iterations_ > 0) {
      delta_f_[slot(1)] = f_ - f_before_;
      delta_q_[slot(1)] = q_ - q_before_;
    }
    f_before_ = f_;
    q_before_ = q_;
    const int count = std::min(iterations_, window);
    ++iterations_;
    if (count > 0) {
      accelerate(count);
      if (descent_.move(problem, p, q_)) return true;
      q_ = q_before_;
    }
    return descent_.move(problem, p, q_);
  }

  const Standing<Field>& standing() const { return descent_.standing(); }

 private:
  static constexpr int window = 5;

  /// Where the differences up to the j-th iteration before this one are kept.
  int slot(int j) const { return (iterations_ - j + window) % window; }

  /// q ← q - Σ_j θ_j Δq_j, the newest differences first: of dependent ones the oldest go unused.
  void accelerate(int count) {
    for (int j = 0; j < count; ++j) columns_[j] = delta_f_[slot(j + 2)];
    residual_ = f_;
    const auto theta = least_squares(count, columns_, residual_);
    for (int j = 0; j < count; ++j) q_ -= theta[j] * delta_q_[slot(j + 2)];
  }

  Descent<Problem> descent_;
  int iterations_ = 0;
  Field f_, f_before_;                           // m: change by the plain iteration
  Field q_, q_before_;                           // m: the plain iterate
  Field residual_;                               // m: scratch
  std::array<Field, window> delta_f_, delta_q_;  // m: rings
  std::array<Field, window> columns_;            // m: scratch
};

}  // namespace mass_spring
