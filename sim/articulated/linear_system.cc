// A = L D L' (Golub and Van Loan, Matrix Computations, 4.1), D kept inverted:
// no roots, one division a row. Row r needs the rows above it only, so the sums
// of one row are independent of each other but for their order, which is fixed.
// With six unknowns, nearly all that there ever are, the rows are written out
// by the compiler: loops over so few numbers cost more than the numbers.

#include "sim/articulated/linear_system.h"

#include <utility>

namespace plsc::articulated {
namespace {

/// Row r of L and of the inverse of D, in place.
inline void FactoriseRow(int r, double* matrix, std::size_t stride) {
  double* const own = matrix + static_cast<std::size_t>(r) * stride;
  // L D first, column by column.
  for (int c = 0; c < r; ++c) {
    const double* const other = matrix + static_cast<std::size_t>(c) * stride;
    for (int k = 0; k < c; ++k) own[c] -= own[k] * other[k];
  }
  double pivot = own[r];
  for (int c = 0; c < r; ++c) {
    const double scaled = own[c] * matrix[static_cast<std::size_t>(c) * stride +
                                          static_cast<std::size_t>(c)];
    pivot -= own[c] * scaled;
    own[c] = scaled;
  }
  own[r] = 1 / pivot;
}

template <int R>
inline void FactoriseRowOf(double (&matrix)[6 * 6]) {
  FactoriseRow(R, matrix, 6);
}

inline void Substitute(int size, const double* matrix, std::size_t stride,
                       double* x) {
  const auto at = [&](int row, int column) {
    return matrix[static_cast<std::size_t>(row) * stride +
                  static_cast<std::size_t>(column)];
  };
  for (int r = 0; r < size; ++r)
    for (int k = 0; k < r; ++k) x[r] -= at(r, k) * x[k];
  for (int r = 0; r < size; ++r) x[r] *= at(r, r);
  for (int r = size; r-- > 0;)
    for (int k = r + 1; k < size; ++k) x[r] -= at(k, r) * x[k];
}

template <int... R>
inline void FactoriseRows(double (&matrix)[6 * 6],
                          std::integer_sequence<int, R...> /*rows*/) {
  (FactoriseRowOf<R>(matrix), ...);
}

}  // namespace

void SolveOfBase(double* matrix, std::size_t stride, double* right) {
  double own[6 * 6];
  for (std::size_t r = 0; r < 6; ++r)
    for (std::size_t c = 0; c <= r; ++c)
      own[r * 6 + c] = matrix[r * stride + c];
  FactoriseRows(own, std::make_integer_sequence<int, 6>());
  double x[6];
  for (int i = 0; i < 6; ++i) x[i] = right[i];
  Substitute(6, own, 6, x);
  for (int i = 0; i < 6; ++i) right[i] = x[i];
}

void SolveOfSize(int size, double* matrix, std::size_t stride, double* right) {
  for (int r = 0; r < size; ++r) FactoriseRow(r, matrix, stride);
  Substitute(size, matrix, stride, right);
}

}  // namespace plsc::articulated
