#include "compact_bfgs.h"

#include <doctest/doctest.h>

#include <deque>

#include "random_scene.h"

namespace mass_spring {
namespace {

constexpr int size = 12;
using Long = Eigen::Matrix<double, size, 1>;
using Square = Eigen::Matrix<double, size, size>;

Square random_square(unsigned seed) {
  const Points entries = random_points(size * size / 3, seed);
  return Eigen::Map<const Square>(entries.data());
}

/// H = (I - s yᵀ/sᵀy) H (I - y sᵀ/sᵀy) + s sᵀ/sᵀy for one pair after the other, from γ Q⁻¹.
Square bfgs(const Square& Q_inverse, const std::deque<Long>& s, const std::deque<Long>& y) {
  Square H = Q_inverse;
  if (!s.empty()) H *= s.back().dot(y.back()) / y.back().dot(Q_inverse * y.back());
  for (std::size_t i = 0; i < s.size(); ++i) {
    const double sy = s[i].dot(y[i]);
    const Square V = Square::Identity() - y[i] * s[i].transpose() / sy;
    H = (V.transpose() * H * V + s[i] * s[i].transpose() / sy).eval();
  }
  return H;
}

}  // namespace

TEST_CASE("the compact form is the BFGS formula of the last pairs") {
  // A quadratic objective of Hessian A, and moves in any direction.
  const Square B = random_square(1), C = random_square(2);
  const Square A = B * B.transpose() + Square::Identity();
  const Square Q_inverse = C * C.transpose() + Square::Identity();
  const Points moves = random_points(4 * 2 * CompactBfgs::window, 3);  // 12 coordinates each
  Long p = Long::Ones();
  std::deque<Long> h, s, y;
  CompactBfgs compact;
  compact.begin();
  for (int iterate = 0; iterate < 2 * CompactBfgs::window; ++iterate) {
    CAPTURE(iterate);
    const Long g = A * p;
    h.push_back(Q_inverse * g);
    CompactBfgs::Numbers products(h.size() + s.size());
    for (std::size_t i = 0; i < h.size(); ++i) products(i) = h[i].dot(g);
    for (std::size_t i = 0; i < s.size(); ++i) products(h.size() + i) = s[i].dot(g);
    REQUIRE(compact.arrive(products));

    const CompactBfgs::Numbers coefficients = compact.coefficients();
    Long x = Long::Zero();
    for (std::size_t i = 0; i < h.size(); ++i) x += coefficients(i) * h[i];
    for (std::size_t i = 0; i < s.size(); ++i) x += coefficients(h.size() + i) * s[i];
    // Conditions below 100, and products of numbers of about 100 that are subtracted.
    CHECK(x.isApprox(bfgs(Q_inverse, s, y) * g, 1e-10));
    CHECK(compact.slope(coefficients) == doctest::Approx(x.dot(g)).epsilon(1e-10));

    s.push_back(Eigen::Map<const Long>(moves.data() + size * iterate));
    y.push_back(A * s.back());
    compact.depart(s.back().dot(g));
    if (s.size() > CompactBfgs::window) {
      h.pop_front();
      s.pop_front();
      y.pop_front();
    }
    CHECK(compact.pairs() == static_cast<int>(s.size()));
    p += s.back();
  }
}

TEST_CASE("without pairs the direction is that of the plain iteration") {
  CompactBfgs compact;
  compact.begin();
  CHECK(compact.arrive(CompactBfgs::Numbers::Constant(1, 4)));
  CHECK(compact.coefficients() == CompactBfgs::Numbers::Constant(1, 1));
  CHECK(compact.slope(CompactBfgs::Numbers::Constant(1, 0.5)) == 2);
}

TEST_CASE("a pair along which E curves downwards is refused") {
  // One number: g = 2 at p = 0, g = 3 at p = -1, Q = 1.
  CompactBfgs compact;
  compact.begin();
  compact.arrive(CompactBfgs::Numbers::Constant(1, 4));
  compact.depart(-2);
  CompactBfgs::Numbers products(3);
  products << 6, 9, -3;
  CHECK_FALSE(compact.arrive(products));
  compact.forget_pairs();
  CHECK(compact.pairs() == 0);
  CHECK(compact.slope(compact.coefficients()) == 9);
}

}  // namespace mass_spring
