#pragma once

// Symmetric, positive definite systems of a handful of unknowns: A x = b.

#include <cstddef>

namespace plsc::articulated {

/// Solves in place: of `matrix`, row by row `stride` apart, the lower half is
/// read and overwritten; `right` becomes the solution. Of a matrix that is not
/// positive definite the result is of no use, and may be no number.
void SolveOfBase(double* matrix, std::size_t stride, double* right);  // 6
void SolveOfSize(int size, double* matrix, std::size_t stride, double* right);

}  // namespace plsc::articulated
