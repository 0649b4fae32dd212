#include "runtime/report/wilcoxon.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

namespace plsc {
namespace {

std::vector<std::string> Split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

/// As the head of tests/data/wilcoxon.tsv says.
std::vector<double> SampleOf(const std::string& text) {
  std::vector<double> sample;
  const std::vector<std::string> parts = Split(text, ':');
  if (parts.size() == 1) {
    for (const std::string& number : Split(text, ','))
      sample.push_back(std::stod(number));
    return sample;
  }
  for (int i = 1; i <= std::stoi(parts[0]); ++i)
    sample.push_back(std::fmod(i * std::stod(parts[1]), 1) +
                     std::stod(parts[2]));
  return sample;
}

}  // namespace

TEST_CASE("W, p and the choice of method are those of R", "[wilcoxon]") {
  std::ifstream file(PLSC_SOURCE_DIR "/tests/data/wilcoxon.tsv");
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#")) continue;
    const std::vector<std::string> cells = Split(line, '\t');
    REQUIRE(cells.size() == 6);
    ++rows;
    DYNAMIC_SECTION(cells[0]) {
      const auto test = RankSumTest(SampleOf(cells[1]), SampleOf(cells[2]));
      REQUIRE(test);
      CHECK(test->w == std::stod(cells[3]));
      // R adds and multiplies in an order of its own.
      CHECK(test->p == Approx(std::stod(cells[4])).epsilon(1e-12).margin(0));
      CHECK(test->is_exact == (cells[5] == "TRUE"));
    }
  }
  CHECK(rows == 19);
}

TEST_CASE("What cannot be tested has no p", "[wilcoxon]") {
  CHECK_FALSE(RankSumTest({}, {1, 2}));
  CHECK_FALSE(RankSumTest({1, 2}, {}));
  CHECK_FALSE(RankSumTest({2, 2}, {2, 2, 2}));  // R: NaN
}

TEST_CASE("The order of samples changes W and not p", "[wilcoxon]") {
  const std::vector<double> x{1, 2, 2, 9};
  const std::vector<double> y{2, 3, 4};
  const auto one = RankSumTest(x, y);
  const auto other = RankSumTest(y, x);
  REQUIRE((one && other));
  CHECK(one->w + other->w == 12);
  CHECK(one->p == Approx(other->p));
}

TEST_CASE("Stars begin below the paper's levels", "[wilcoxon]") {
  CHECK(Stars(0.0009) == "***");
  CHECK(Stars(0.001) == "**");
  CHECK(Stars(0.0099) == "**");
  CHECK(Stars(0.01) == "*");
  CHECK(Stars(0.0499) == "*");
  CHECK(Stars(0.05).empty());
  CHECK(Stars(1).empty());
}

}  // namespace plsc
