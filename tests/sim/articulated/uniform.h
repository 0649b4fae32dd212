#pragma once

// Random numbers that are the same with every library.

#include <random>

namespace plsc::test {

inline double Uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

}  // namespace plsc::test
