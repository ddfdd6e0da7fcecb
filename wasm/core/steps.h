#pragma once

#include <algorithm>
#include <array>

#include "linear_span.h"

namespace mass_spring {

/// The last steps of a method that makes the next one of them: for each iterate h = Q⁻¹ ∂E/∂p, m,
/// and s, m, from there to the next. Only begin() allocates.
/// @tparam Field   of floats or doubles, one vertex a row
/// @tparam window  how many steps are kept
template <typename Field, int window>
class Steps {
 public:
  using Span = LinearSpan<Field, 2 * window + 1>;
  /// One number for every h, the present iterate's last, then one for every s that led to it.
  using Numbers = typename Span::Numbers;

  /// @param p  of the shape that the fields shall have
  template <typename Positions>
  void begin(const Positions& p) {
    for (auto* fields : {&h_, &s_}) {
      for (Field& field : *fields) field.resizeLike(p);
    }
    count_ = 0;
  }

  /// How many are kept of those that led to the present iterate.
  int count() const { return count_; }

  Field& h() { return h_[count_]; }
  Field& s() { return s_[count_]; }

  Span every_h() const {
    Span span;
    for (int i = 0; i <= count_; ++i) span.add(h_[i]);
    return span;
  }
  Span every_h_and_s() const {
    Span span = every_h();
    for (int i = 0; i < count_; ++i) span.add(s_[i]);
    return span;
  }

  /// On to the next iterate; of more than `window` steps the oldest is forgotten.
  void advance() {
    if (count_ < window) {
      ++count_;
      return;
    }
    std::rotate(h_.begin(), h_.begin() + 1, h_.end());
    std::rotate(s_.begin(), s_.begin() + 1, s_.end());
  }

  /// Forgets how the present iterate was reached.
  void forget() {
    h_[0].swap(h_[count_]);
    count_ = 0;
  }

 private:
  int count_ = 0;
  std::array<Field, window + 1> h_, s_;
};

}  // namespace mass_spring
