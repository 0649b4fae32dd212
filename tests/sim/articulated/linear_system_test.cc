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

/// How far solutions may be apart: both err by as many roundings as there are
/// unknowns, times the condition. 4 was not reached by far.
double AllowedOf(Index size, double condition) {
  return 4 * static_cast<double>(size) * condition *
         std::numeric_limits<double>::epsilon();
}

VectorXd DrawRight(Index size, std::mt19937& random) {
  VectorXd right(size);
  for (double& entry : right) entry = test::Uniform(random, -1, 1);
  return right;
}

TEST_CASE("Linear systems have Eigen's solutions", "[linear_system]") {
  std::mt19937 random(4);  // any
  for (const Index size : {1, 2, 3, 6, 7, 11, 24, 40}) {
    for (const double condition : {1.0, 1e3, 1e6, 1e9}) {
      CAPTURE(size, condition);
      const MatrixXd matrix = RandomMatrix(size, condition, random);
      const VectorXd right = DrawRight(size, random);
      const VectorXd expected = matrix.ldlt().solve(right);
      const auto stride = static_cast<std::size_t>(size) + 3;
      VectorXd solution = right;
      SolveSystem(static_cast<int>(size), Filed(matrix, stride).data(), stride,
                  solution.data());
      CHECK((solution - expected).norm() <=
            AllowedOf(size, condition) * expected.norm());
    }
  }
}

TEST_CASE("The base's system has Eigen's solutions", "[linear_system]") {
  std::mt19937 random(5);  // any
  for (const double weight : {1e-3, 1.0, 1e3, 1e6}) {
    CAPTURE(weight);
    // A part that is any, weighed, of which three unknowns do not act on each
    // other, and enough on the diagonal.
    MatrixXd matrix = weight * RandomMatrix(6, 10, random);
    const VectorXd own = matrix.diagonal().tail(3);
    matrix.bottomRightCorner(3, 3) = own.asDiagonal();
    matrix.diagonal().array() += 30 * weight;
    matrix.diagonal().array() += 1;
    const VectorXd right = DrawRight(6, random);
    const VectorXd expected = matrix.ldlt().solve(right);
    std::vector<double> filed = Filed(matrix, 9);
    // Not read, as it is 0.
    filed[4 * 9 + 3] = filed[5 * 9 + 3] = filed[5 * 9 + 4] =
        std::numeric_limits<double>::quiet_NaN();
    VectorXd solution = right;
    SolveOfBase(filed.data(), 9, solution.data());
    CHECK((solution - expected).norm() <= AllowedOf(6, 1) * expected.norm());
  }
}

TEST_CASE("A system that is not positive definite is no harm",
          "[linear_system]") {
  for (const double entry :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    MatrixXd matrix = MatrixXd::Identity(6, 6);
    matrix(2, 2) = entry;
    VectorXd all = VectorXd::Ones(6), of_base = all;
    SolveSystem(6, Filed(matrix, 6).data(), 6, all.data());
    SolveOfBase(Filed(matrix, 6).data(), 6, of_base.data());
    CHECK((entry == -1 ? all[2] == -1 : !std::isfinite(all[2])));
    CHECK((entry == -1 ? of_base[2] == -1 : !of_base.allFinite()));
  }
}

}  // namespace
}  // namespace plsc::articulated
