#pragma once

// Are two sets of counts drawn from the same distribution? For comparing our
// random operators with counts of the authors' program, and with theory.

#include <vector>

namespace plsc::test {

/// Significance of every comparison here. Seeds are constants, so a test that
/// passes always passes; of 100 right ones about 0.01 would fail when written.
inline constexpr double kSignificance = 1e-4;

/// Probability of a chi-square of at least `x` with `degrees` of freedom.
double ChiSquareTail(double x, int degrees);

/// Of counts against probabilities that need not be normalised.
double PValue(const std::vector<int>& counts,
              const std::vector<double>& expected);

/// Of two samples of possibly different sizes (homogeneity). Categories that
/// neither has are left out.
double PValue(const std::vector<int>& counts, const std::vector<int>& others);

}  // namespace plsc::test
