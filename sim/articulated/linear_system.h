#pragma once

// Symmetric, positive definite systems of a handful of unknowns: A x = b.

#include <cstddef>

namespace plsc::articulated {

/// Solves in place: of `matrix`, row by row `stride` apart, the lower half is
/// read and overwritten; `right` becomes the solution. Of a matrix that is not
/// positive definite the result is of no use, and may be no number.
void SolveSystem(int size, double* matrix, std::size_t stride, double* right);

/// The same of 6 unknowns, the last three of which do not act on each other:
/// entries (4, 3), (5, 3), (5, 4) are 0 and not read. `matrix` is kept.
void SolveOfBase(const double* matrix, std::size_t stride, double* right);

}  // namespace plsc::articulated
