#pragma once

#include <Eigen/Core>
#include <array>
#include <cstring>

namespace mass_spring {

/// Fields of one shape, of which all products with another one or any combination are wanted: one
/// pass over memory, whatever their number. Lends them.
///
/// Coordinates are taken in chunks whose sums are added in double, in an order that does not depend
/// on the machine's registers.
/// @tparam Field  of floats or doubles
/// @tparam most   how many fields there may be
template <typename Field, int most>
class LinearSpan {
 public:
  using Scalar = typename Field::Scalar;
  /// One number for every field.
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>;

  void add(const Field& field) { fields_[count_++] = field.data(); }

  /// @return  #fields: Σ field_i · g_i over all rows
  Numbers products(const Field& g) const {
    Sums sums[most] = {};
    const Eigen::Index whole = whole_chunks(g);
    for (Eigen::Index i = 0; i < whole; i += chunk) {
      Lanes g_i[parts], a[parts];
      std::memcpy(g_i, g.data() + i, sizeof g_i);
      for (int f = 0; f < count_; ++f) {
        std::memcpy(a, fields_[f] + i, sizeof a);
        for (int part = 0; part < parts; ++part) a[part] *= g_i[part];
        for (int part = 1; part < parts; ++part) a[0] += a[part];
        sums[f] += __builtin_convertvector(a[0], Sums);
      }
    }
    Numbers products(count_);
    for (int f = 0; f < count_; ++f) {
      products(f) = (sums[f][0] + sums[f][1]) + (sums[f][2] + sums[f][3]);
      for (Eigen::Index i = whole; i < g.size(); ++i) products(f) += fields_[f][i] * g.data()[i];
    }
    return products;
  }

  /// @param coefficients  #fields
  /// @param x             Σ coefficient · field (result)
  void combine(const Numbers& coefficients, Field& x) const {
    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1, 0, most, 1> c =
        coefficients.template cast<Scalar>();
    const Eigen::Index whole = whole_chunks(x);
    for (Eigen::Index i = 0; i < whole; i += chunk) {
      Lanes sums[parts] = {}, a[parts];
      for (int f = 0; f < count_; ++f) {
        std::memcpy(a, fields_[f] + i, sizeof a);
        for (int part = 0; part < parts; ++part) sums[part] += c(f) * a[part];
      }
      std::memcpy(x.data() + i, sums, sizeof sums);
    }
    for (Eigen::Index i = whole; i < x.size(); ++i) {
      x.data()[i] = 0;
      for (int f = 0; f < count_; ++f) x.data()[i] += c(f) * fields_[f][i];
    }
  }

 private:
  static constexpr int lanes = 4;
  static constexpr int parts = 4;
  static constexpr int chunk = lanes * parts;
  // Not `using`, of which GCC would ignore the attribute.
  typedef Scalar Lanes __attribute__((vector_size(lanes * sizeof(Scalar))));
  typedef double Sums __attribute__((vector_size(lanes * sizeof(double))));

  static Eigen::Index whole_chunks(const Field& field) { return field.size() / chunk * chunk; }

  std::array<const Scalar*, most> fields_;
  int count_ = 0;
};

}  // namespace mass_spring
