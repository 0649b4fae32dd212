#pragma once

// Numbers and turns as the files of other programs hold them: with 15 digits,
// so that 0.0555 is not 0.055499999999999994, and without the traces of
// rounding where there is nothing. That moves nothing by more than 1e-15 m.

#include <Eigen/Core>
#include <string>

namespace plsc {

/// "0.1", "1e-05", "2"; never "-0" or "1.2e-17".
std::string NumberText(double number);
/// Separated by blanks.
std::string NumbersText(const Eigen::Vector3d& numbers);
/// "w x y z" of the turn whose axes are the columns.
std::string QuaternionText(const Eigen::Matrix3d& axes);

/// rad, about the fixed axes x, y, z in this order, as URDF and SDFormat have
/// it. A pitch of a quarter turn, as parts have, leaves a choice: the roll is 0
/// then (sim/recorder, of moving robots, leaves that to rounding).
Eigen::Vector3d FixedAngles(const Eigen::Matrix3d& axes);

}  // namespace plsc
