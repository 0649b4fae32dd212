#include "runtime/report/wilcoxon.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

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

/// Compares with each row of a file of tests/data. How many there are.
int CompareWithR(const std::string& name) {
  std::ifstream file(PLSC_SOURCE_DIR "/tests/data/" + name);
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("#")) continue;
    const std::vector<std::string> cells = Split(line, '\t');
    REQUIRE(cells.size() == 6);
    ++rows;
    INFO(cells[0]);
    const auto test = RankSumTest(SampleOf(cells[1]), SampleOf(cells[2]));
    REQUIRE(test);
    CHECK(test->w == std::stod(cells[3]));
    // R counts with doubles, and takes all ways from a logarithm.
    CHECK(test->p == Approx(std::stod(cells[4])).epsilon(1e-12).margin(0));
    CHECK(test->is_exact == (cells[5] == "TRUE"));
  }
  return rows;
}

/// The recurrence of Mann and Whitney (1947), as they have it.
double Ways(int m, int n, int w) {
  if (w < 0) return 0;
  if (m == 0 || n == 0) return w == 0 ? 1 : 0;
  return Ways(m - 1, n, w - n) + Ways(m, n - 1, w);
}

/// Samples of these sizes with this W.
std::pair<std::vector<double>, std::vector<double>> SamplesOf(int m, int n,
                                                              int w) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 1; i <= n; ++i) y.push_back(i);
  // Each of x above as many of y as it can be, while any are left.
  for (int i = 0; i < m; ++i) {
    const int above = std::min(n, w);
    w -= above;
    x.push_back(above + (i + 1) / (m + 1.0));
  }
  return {x, y};
}

}  // namespace

TEST_CASE("W, p and the choice of method are those of R", "[wilcoxon]") {
  CHECK(CompareWithR("wilcoxon.tsv") == 19);
  CHECK(CompareWithR("rank_sums.tsv") == 200);
}

TEST_CASE("p is exact for small samples", "[wilcoxon]") {
  for (int m = 1; m <= 6; ++m) {
    for (int n = 1; n <= 5; ++n) {
      double all = 0;
      for (int w = 0; w <= m * n; ++w) all += Ways(m, n, w);
      double below = 0;
      for (int w = 0; 2 * w <= m * n; ++w) {
        below += Ways(m, n, w);
        for (const int either : {w, m * n - w}) {
          CAPTURE(m, n, either);
          const auto [x, y] = SamplesOf(m, n, either);
          const auto test = RankSumTest(x, y);
          REQUIRE(test);
          CHECK(test->w == either);
          CHECK(test->p == std::min(1.0, 2 * below / all));
        }
      }
    }
  }
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
