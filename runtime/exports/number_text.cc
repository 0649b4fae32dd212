#include "runtime/exports/number_text.h"

#include <Eigen/Geometry>
#include <cmath>

#include "grammar/number.h"
#include "sim/maths/arc.h"
#include "sim/maths/hypot.h"

namespace plsc {

std::string NumberText(double number) {
  // m, kg, kg m2: parts have millimetres, grams and 1e-7 kg m2 at least.
  constexpr double kNothing = 1e-15;
  return std::abs(number) < kNothing ? "0" : PrintRoundedNumber(number, 15);
}

std::string NumbersText(const Eigen::Vector3d& numbers) {
  return NumberText(numbers.x()) + " " + NumberText(numbers.y()) + " " +
         NumberText(numbers.z());
}

std::string QuaternionText(const Eigen::Matrix3d& axes) {
  const Eigen::Quaterniond turn(axes);
  return NumberText(turn.w()) + " " + NumbersText(turn.vec());
}

Eigen::Vector3d FixedAngles(const Eigen::Matrix3d& axes) {
  const double level = Hypot(axes(0, 0), axes(1, 0));
  const double pitch = Atan2(-axes(2, 0), level);
  // The turns of modules are whole quarters, exact to 1e-16.
  constexpr double kUpright = 1e-9;
  if (level < kUpright) return {0, pitch, Atan2(-axes(0, 1), axes(1, 1))};
  return {Atan2(axes(2, 1), axes(2, 2)), pitch, Atan2(axes(1, 0), axes(0, 0))};
}

}  // namespace plsc
