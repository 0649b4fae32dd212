#include "sim/articulated/linear_system.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/sim/articulated/uniform.h"

namespace plsc::articulated {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Positive definite, its largest eigenvalue `condition` times its least.
MatrixXd RandomMatrix(Index size, double condition, std::mt19937& random) {
  MatrixXd square(size, size);
  for (double& entry : square.reshaped()) entry = test::Uniform(random, -1, 1);
  const MatrixXd axes = square.householderQr().householderQ();
  VectorXd sizes(size);
  for (Index i = 0; i < size; ++i)
    sizes[i] = std::pow(
        condition,
        size > 1 ? static_cast<double>(i) / static_cast<double>(size - 1) : 0);
  return axes * sizes.asDiagonal() * axes.transpose();
}

/// As rows `stride` apart, with what must not be read no number.
std::vector<double> Filed(const MatrixXd& matrix, std::size_t stride) {
  const auto size = static_cast<std::size_t>(matrix.rows());
  std::vector<double> rows(size * stride,
                           std::numeric_limits<double>::quiet_NaN());
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = 0; c <= r; ++c)
      rows[r * stride + c] =
          matrix(static_cast<Index>(r), static_cast<Index>(c));
  return rows;
}

TEST_CASE("Linear systems have Eigen's solutions", "[linear_system]") {
  std::mt19937 random(4);  // any
  for (const Index size : {1, 2, 3, 6, 7, 11, 24, 40}) {
    for (const double condition : {1.0, 1e3, 1e6, 1e9}) {
      CAPTURE(size, condition);
      const MatrixXd matrix = RandomMatrix(size, condition, random);
      VectorXd right(size);
      for (double& entry : right) entry = test::Uniform(random, -1, 1);
      const VectorXd expected = matrix.ldlt().solve(right);
      // Both err by as many roundings as there are unknowns, times the
      // condition; 4 was not reached by far.
      const double allowed = 4 * static_cast<double>(size) * condition *
                             std::numeric_limits<double>::epsilon();
      const auto check = [&](const VectorXd& solution) {
        CHECK((solution - expected).norm() <= allowed * expected.norm());
      };
      const auto stride = static_cast<std::size_t>(size) + 3;
      VectorXd solution = right;
      SolveOfSize(static_cast<int>(size), Filed(matrix, stride).data(), stride,
                  solution.data());
      check(solution);
      if (size != 6) continue;
      solution = right;
      SolveOfBase(Filed(matrix, stride).data(), stride, solution.data());
      check(solution);
    }
  }
}

TEST_CASE("A system that is not positive definite is no harm",
          "[linear_system]") {
  for (const double entry :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    MatrixXd matrix = MatrixXd::Identity(6, 6);
    matrix(2, 2) = entry;
    VectorXd right = VectorXd::Ones(6);
    SolveOfBase(Filed(matrix, 6).data(), 6, right.data());
    CHECK((entry == -1 ? right[2] == -1 : !std::isfinite(right[2])));
  }
}

}  // namespace
}  // namespace plsc::articulated
