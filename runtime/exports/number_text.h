#pragma once

// Numbers and turns as the files of other programs hold them: with as few
// digits as give the same double back.

#include <Eigen/Core>
#include <string>

namespace plsc {

/// "0.1", "1e-05", "2"; never "-0".
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
