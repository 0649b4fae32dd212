// A = L D L' (Golub and Van Loan, Matrix Computations, 4.1), D kept inverted:
// no roots, one division a row. Row r needs the rows above it only, and all
// sums run in one order.
//
// Of the base's six unknowns the velocities act on each other through the turn
// alone as long as the ground is a plane, which is nearly always. With A of the
// spin w, C (diagonal) of the velocity v and B between them,
//
//   v = C^-1 (g - B w),   (A - B' C^-1 B) w = f - B' C^-1 g,
//
// three independent divisions and a system of three.

#include "sim/articulated/linear_system.h"

namespace plsc::articulated {

void SolveSystem(int size, double* matrix, std::size_t stride, double* right) {
  const auto row = [&](int r) {
    return matrix + static_cast<std::size_t>(r) * stride;
  };
  for (int r = 0; r < size; ++r) {
    double* const own = row(r);
    // L D first, column by column.
    for (int c = 0; c < r; ++c) {
      const double* const other = row(c);
      for (int k = 0; k < c; ++k) own[c] -= own[k] * other[k];
    }
    double pivot = own[r];
    for (int c = 0; c < r; ++c) {
      const double scaled = own[c] * row(c)[c];
      pivot -= own[c] * scaled;
      own[c] = scaled;
    }
    own[r] = 1 / pivot;
  }
  double* const x = right;
  for (int r = 0; r < size; ++r)
    for (int k = 0; k < r; ++k) x[r] -= row(r)[k] * x[k];
  for (int r = size; r-- > 0;) {
    x[r] *= row(r)[r];
    for (int k = r + 1; k < size; ++k) x[r] -= row(k)[r] * x[k];
  }
}

void SolveOfBase(const double* matrix, std::size_t stride, double* right) {
  const double* const a0 = matrix;
  const double* const a1 = matrix + stride;
  const double* const a2 = matrix + 2 * stride;
  double a00 = a0[0], a10 = a1[0], a11 = a1[1];
  double a20 = a2[0], a21 = a2[1], a22 = a2[2];
  double f0 = right[0], f1 = right[1], f2 = right[2];
  double scaled[3][3];  // C^-1 B
  double g[3];          // C^-1 g
  for (std::size_t i = 0; i < 3; ++i) {
    const double* const b = matrix + (3 + i) * stride;
    const double inverse = 1 / b[3 + i];
    for (std::size_t k = 0; k < 3; ++k) scaled[i][k] = inverse * b[k];
    g[i] = inverse * right[3 + i];
    a00 -= b[0] * scaled[i][0];
    a10 -= b[1] * scaled[i][0];
    a11 -= b[1] * scaled[i][1];
    a20 -= b[2] * scaled[i][0];
    a21 -= b[2] * scaled[i][1];
    a22 -= b[2] * scaled[i][2];
    f0 -= b[0] * g[i];
    f1 -= b[1] * g[i];
    f2 -= b[2] * g[i];
  }
  // L D L' of what is left, and w.
  const double d0 = 1 / a00;
  const double l10 = a10 * d0, l20 = a20 * d0;
  const double d1 = 1 / (a11 - l10 * a10);
  const double ld21 = a21 - l20 * a10;
  const double l21 = ld21 * d1;
  const double d2 = 1 / (a22 - l20 * a20 - l21 * ld21);
  f1 -= l10 * f0;
  f2 -= l20 * f0 + l21 * f1;
  const double w2 = f2 * d2;
  const double w1 = f1 * d1 - l21 * w2;
  const double w0 = f0 * d0 - l10 * w1 - l20 * w2;
  right[0] = w0;
  right[1] = w1;
  right[2] = w2;
  for (std::size_t i = 0; i < 3; ++i)
    right[3 + i] =
        g[i] - (scaled[i][0] * w0 + scaled[i][1] * w1 + scaled[i][2] * w2);
}

}  // namespace plsc::articulated
