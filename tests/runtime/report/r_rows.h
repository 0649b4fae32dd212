#pragma once

// What R says of the statistics of claims: rows of
// tests/data/claim_statistics.tsv.

#include <string>
#include <vector>

namespace plsc::test {

struct RRow {
  std::vector<double> x, y;
  std::vector<double> numbers;
};
/// "superiority", "paired", "median", "mean", "holm" or "share"; fails if there
/// is none.
std::vector<RRow> RRows(const std::string& kind);

}  // namespace plsc::test
