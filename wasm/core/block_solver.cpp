#include "block_solver.h"

#include <algorithm>
#include <type_traits>

#include "dot.h"

namespace mass_spring {
namespace {

constexpr int strip_width = 4;

/// Calls do_strip(first column, width) with the width as a type, so that its loop has a fixed
/// length.
template <typename DoStrip>
void for_each_strip(int columns, DoStrip do_strip) {
  int c = 0;
  for (; c + strip_width <= columns; c += strip_width) {
    do_strip(c, std::integral_constant<int, strip_width>());
  }
  switch (columns - c) {
    case 1:
      return do_strip(c, std::integral_constant<int, 1>());
    case 2:
      return do_strip(c, std::integral_constant<int, 2>());
    case 3:
      return do_strip(c, std::integral_constant<int, 3>());
  }
}

/// A row of x in registers.
template <typename Scalar>
using Row = decltype(load_point(static_cast<const Scalar*>(nullptr), 0));

/// x_R ← x_R + G x_C.
/// @param G  height by Width
template <int Width, typename Scalar>
void add_product(const Scalar* G, int height, const int* rows, int C, Scalar* x) {
  Row<Scalar> kept[Width];
  for (int c = 0; c < Width; ++c) kept[c] = load_point(x, C + c);
  for (int i = 0; i < height; ++i) {
    Row<Scalar> sum = load_point(x, rows[i]);
    for (int c = 0; c < Width; ++c) sum += G[i * Width + c] * kept[c];
    store_point(sum, x, rows[i]);
  }
}

/// x_C ← Bᵀ z.
/// @param B  height by Width
template <int Width, typename Scalar>
void transposed_product(const Scalar* B, int height, const Scalar* z, int C, Scalar* x) {
  Row<Scalar> sums[Width] = {};
  for (int i = 0; i < height; ++i) {
    const Row<Scalar> z_i = load_point(z, i);
    for (int c = 0; c < Width; ++c) sums[c] += B[i * Width + c] * z_i;
  }
  for (int c = 0; c < Width; ++c) store_point(sums[c], x, C + c);
}

/// From [L_CC; L_RC], row-major, to [D; G] in strips.
class PanelInversion {
 public:
  void invert(const Supernode& node, double* panel) {
    const int width = node.width, length = node.width + node.height;
    L_.assign(panel, panel + static_cast<std::int64_t>(length) * width);
    invert_triangle(width);
    // D = T Tᵀ and G = -L_RC Tᵀ with T = L_CC⁻ᵀ, whose rows are zero left of the diagonal.
    for_each_strip(width, [&](int first, auto strip) {
      double* entry = panel + static_cast<std::int64_t>(first) * length;
      for (int i = 0; i < length; ++i) {
        for (int c = first; c < first + strip; ++c, ++entry) {
          const int begin = i < width ? std::max(i, c) : c;
          const double* T_c = &T_[c * width];
          *entry = i < width ? dot(&T_[i * width + begin], T_c + begin, width - begin)
                             : -dot(&L_[i * width + begin], T_c + begin, width - begin);
        }
      }
    });
  }

 private:
  /// Column by column of L_CC⁻¹: L_CC (row c of T)ᵀ = unit vector c.
  void invert_triangle(int width) {
    T_.assign(width * width, 0);
    for (int c = 0; c < width; ++c) {
      double* T_c = &T_[c * width];
      T_c[c] = 1 / L_[c * width + c];
      for (int i = c + 1; i < width; ++i) {
        T_c[i] = -dot(&L_[i * width + c], T_c + c, i - c) / L_[i * width + i];
      }
    }
  }

  std::vector<double> L_;  // length by width
  std::vector<double> T_;  // width by width
};

}  // namespace

bool BlockSolver::factorise(const SymbolicCholesky& symbolic, double coupling,
                            const Vector& diagonal, const Progress& progress) {
  if (!numeric_cholesky(symbolic, coupling, diagonal, progress, doubles_.panels)) return false;
  PanelInversion inversion;
  for (const Supernode& node : symbolic.supernodes) {
    inversion.invert(node, doubles_.panels.data() + node.panel);
  }
  floats_.panels.assign(doubles_.panels.begin(), doubles_.panels.end());
  doubles_.gathered.resize(symbolic.largest_panel, 4);
  floats_.gathered.resize(symbolic.largest_panel, 4);
  return true;
}

void BlockSolver::solve(const SymbolicCholesky& symbolic, WidePoints& x) {
  doubles_.solve(symbolic, x);
}

void BlockSolver::solve(const SymbolicCholesky& symbolic, RoughPoints& x) {
  floats_.solve(symbolic, x);
}

template <typename Scalar>
void BlockSolver::Sweeps<Scalar>::solve(const SymbolicCholesky& symbolic, WideRows<Scalar>& x) {
  for (const Supernode& node : symbolic.supernodes) {
    const Scalar* panel = panels.data() + node.panel;
    const int* rows = symbolic.rows.data() + node.rows;
    const int length = node.width + node.height;
    for_each_strip(node.width, [&](int first, auto strip) {
      const Scalar* G = panel + first * length + node.width * strip;
      add_product<strip>(G, node.height, rows, node.first_column + first, x.data());
    });
  }
  for (auto node = symbolic.supernodes.rbegin(); node != symbolic.supernodes.rend(); ++node) {
    const Scalar* panel = panels.data() + node->panel;
    const int* rows = symbolic.rows.data() + node->rows;
    const int length = node->width + node->height;
    gathered.topRows(node->width) = x.middleRows(node->first_column, node->width);
    for (int i = 0; i < node->height; ++i) {
      store_point(load_point(x.data(), rows[i]), gathered.data(), node->width + i);
    }
    for_each_strip(node->width, [&](int first, auto strip) {
      transposed_product<strip>(panel + first * length, length, gathered.data(),
                                node->first_column + first, x.data());
    });
  }
}

}  // namespace mass_spring
