#pragma once

// Formulas drawn at random, as text and as what they mean: each comes with a
// function that works it out by itself, lazily, and knows of no tree.

#include <functional>
#include <optional>
#include <random>
#include <span>
#include <string>

namespace plsc::test {

struct RandomFormula {
  std::string text;
  /// Nothing where anything on the way is no finite number.
  std::function<std::optional<double>(std::span<const double>)> value;
};

/// Of a number, nested at most so deep.
RandomFormula DrawNumber(std::mt19937& random, int depth);

}  // namespace plsc::test
