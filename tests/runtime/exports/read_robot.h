#pragma once

// What a reader of another program understood of an exported robot, in the
// robot's frame at rest, and its comparison with what plsc simulates and with
// what the authors' program assembled. Each reader's test fills one.

#include <Eigen/Core>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/exports/robot_model.h"

namespace plsc::test {

struct ReadBox {
  Eigen::Vector3d centre;  ///< m
  Eigen::Matrix3d axes;
  Eigen::Vector3d size;  ///< m
};

struct ReadLink {
  double mass = 0;          ///< kg
  Eigen::Vector3d centre;   ///< m, of mass
  Eigen::Matrix3d inertia;  ///< kg m2
  std::map<std::string, ReadBox> boxes;
};

struct ReadJoint {
  std::string parent, child;
  Eigen::Vector3d anchor, axis;
  double lower = 0, upper = 0;  ///< rad
  double torque = 0;            ///< N m, at most
  double speed = 0;             ///< rad/s, at most
};

struct ReadRobot {
  std::map<std::string, ReadLink> links;
  std::map<std::string, ReadJoint> joints;
  std::vector<std::string> touch_sensors;  ///< names
  bool has_imu = false;
};

/// Every link, box, joint and sensor is there, nothing else is, and all
/// numbers agree.
void CheckIsModel(const ReadRobot& read, const RobotModel& model);

/// A body of tests/data/geometry.json and what the authors' program made of
/// it, under its names.
struct AuthorsRobot {
  std::string name;
  RobotModel model;
  nlohmann::json geometry;
};
const std::vector<AuthorsRobot>& AuthorsRobots();
void CheckIsAuthors(const ReadRobot& read, const AuthorsRobot& robot);

/// Robots that a format must be able to say: the authors' bodies, those of a
/// share of the samples, and odd ones.
const std::vector<RobotModel>& ManyModels();

RobotModel ModelOfBody(const Body& body, const std::string& name);

}  // namespace plsc::test
