#include "runtime/exports/number_text.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

namespace plsc {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("Numbers have 15 digits, and none of rounding's traces",
          "[number_text]") {
  struct Row {
    const char* why;
    double number;
    const char* text;
  };
  const Row rows[] = {
      {"short", 0.1, "0.1"},
      {"whole", 2, "2"},
      {"the 16th digit is rounding", 0.055499999999999994, "0.0555"},
      {"small", 3.1661093750000003e-06, "3.166109375e-06"},
      {"nothing but rounding", -1.3877787807814457e-17, "0"},
      {"zero without sign", -0.0, "0"},
      {"large", 1e7 / 3, "3333333.33333333"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    CHECK(NumberText(row.number) == row.text);
  }
  CHECK(NumbersText({1, -0.5, 0}) == "1 -0.5 0");
  CHECK(QuaternionText(Matrix3d::Identity()) == "1 0 0 0");
}

Matrix3d TurnOf(const Vector3d& angles) {
  return (AngleAxisd(angles.z(), Vector3d::UnitZ()) *
          AngleAxisd(angles.y(), Vector3d::UnitY()) *
          AngleAxisd(angles.x(), Vector3d::UnitX()))
      .toRotationMatrix();
}

TEST_CASE("Fixed angles give the turn back, quarters of pitch too",
          "[number_text]") {
  constexpr double kQuarter = std::numbers::pi / 2;
  int turns = 0;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z)
        for (const double off : {0.0, 0.3}) {
          const Matrix3d turn =
              TurnOf({x * kQuarter + off, y * kQuarter, z * kQuarter - off});
          CHECK((TurnOf(FixedAngles(turn)) - turn).norm() < 1e-14);
          ++turns;
        }
  CHECK(turns == 128);
}

}  // namespace
}  // namespace plsc
