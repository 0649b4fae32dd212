#include "tests/runtime/report/r_rows.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

namespace plsc::test {

namespace {

std::vector<double> NumbersIn(const std::string& text, char separator) {
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    numbers.push_back(std::stod(part));
  return numbers;
}

}  // namespace

std::vector<RRow> RRows(const std::string& kind) {
  std::ifstream file(PLSC_SOURCE_DIR "/tests/data/claim_statistics.tsv");
  std::vector<RRow> rows;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string name, x, y, rest;
    std::getline(cells, name, '\t');
    if (name != kind) continue;
    std::getline(cells, x, '\t');
    std::getline(cells, y, '\t');
    std::getline(cells, rest);
    rows.push_back(
        {NumbersIn(x, ','), NumbersIn(y, ','), NumbersIn(rest, '\t')});
  }
  REQUIRE_FALSE(rows.empty());
  return rows;
}

}  // namespace plsc::test
