#include "tests/runtime/vary/kolmogorov.h"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/runtime/vary/chi_square.h"

namespace plsc::test {

namespace {

std::vector<double> Grid(int count, double low, double high) {
  std::vector<double> sample;
  for (int i = 0; i < count; ++i)
    sample.push_back(low + (high - low) * (i + 0.5) / count);
  return sample;
}

}  // namespace

TEST_CASE("Kolmogorov's law has the values of its tables", "[kolmogorov]") {
  // A sample of n on a grid shifted by d has the distance d + 1/(2n). The
  // critical values of sqrt(n) D are 1.2239 at 0.10 and 1.3581 at 0.05.
  struct Row {
    double statistic, p;
  };
  for (const Row& row :
       std::vector<Row>{{1.2239, 0.10}, {1.3581, 0.05}, {1.6276, 0.01}}) {
    const int n = 10000;
    const double shift = row.statistic / 100 - 0.5 / n;
    const std::vector<double> sample = Grid(n, -shift, 1 - shift);
    const double p =
        KolmogorovPValue(sample, [](double x) { return UniformCdf(x, 0, 1); });
    CHECK(p == Approx(row.p).epsilon(0.01));
  }
}

TEST_CASE("A sample is told from the wrong distribution", "[kolmogorov]") {
  const std::vector<double> sample = Grid(1000, -1, 1);
  CHECK(KolmogorovPValue(sample, [](double x) {
          return UniformCdf(x, -1, 1);
        }) > kSignificance);
  CHECK(KolmogorovPValue(sample, [](double x) {
          return UniformCdf(x, -1, 1.2);
        }) < kSignificance);
  CHECK(KolmogorovPValue(sample, NormalCdf) < kSignificance);
}

TEST_CASE("The normal distribution function is the known one", "[kolmogorov]") {
  CHECK(NormalCdf(0) == 0.5);
  CHECK(NormalCdf(1.959964) == Approx(0.975).epsilon(1e-6));
  CHECK(NormalCdf(-1.959964) == Approx(0.025).epsilon(1e-5));
}

}  // namespace plsc::test
