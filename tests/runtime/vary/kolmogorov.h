#pragma once

// Is a sample of real numbers drawn from a distribution? The test of
// Kolmogorov and Smirnov, for arguments that our operators draw.

#include <functional>
#include <vector>

namespace plsc::test {

/// Probability of a greatest distance as large as the sample's from the
/// distribution function `cdf`, by the asymptotic law, which wants a sample of
/// at least 40.
double KolmogorovPValue(std::vector<double> sample,
                        const std::function<double(double)>& cdf);

/// Distribution functions.
double UniformCdf(double x, double low, double high);
double NormalCdf(double x);  ///< mean 0, standard deviation 1

}  // namespace plsc::test
