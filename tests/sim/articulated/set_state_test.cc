// States that are set from outside, also such as no robot of rigid joints has.

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/sim/articulated/driven.h"
#include "tests/sim/articulated/uniform.h"

namespace plsc {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Snapshot {
  std::vector<LinkPose> poses;
  std::vector<LinkMotion> motions;
};

Snapshot SnapshotOf(const test::Driven& robot) {
  Snapshot state;
  for (int link = 0; link < robot.links(); ++link) {
    state.poses.push_back(robot.engine.PoseOf(link));
    state.motions.push_back(robot.engine.MotionOf(link));
  }
  return state;
}

void Set(const Snapshot& state, bool is_backwards, test::Driven& robot) {
  for (int i = 0; i < robot.links(); ++i) {
    const int link = is_backwards ? robot.links() - 1 - i : i;
    const auto k = static_cast<std::size_t>(link);
    robot.engine.SetState(link, state.poses[k], state.motions[k]);
  }
}

/// m: how far the two links of any joint are from meeting at its anchor.
double GapOfJoints(const test::Driven& robot) {
  double most = 0;
  for (const Hinge& hinge : robot.assembly.hinges) {
    const auto place = [&](int link) -> Vector3d {
      const LinkPose pose = robot.engine.PoseOf(link);
      const auto k = static_cast<std::size_t>(link);
      return pose.position +
             pose.axes * (hinge.anchor - robot.assembly.links[k].centre);
    };
    most = std::max(most, (place(hinge.parent) - place(hinge.child)).norm());
  }
  return most;
}

TEST_CASE("A state that is set is the state", "[set_state]") {
  std::mt19937 random(3);  // any
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const Phenotype robot = RandomRobot(3 + i % 12, random);
    const Terrain ground = i % 2 == 0 ? Terrain{} : test::Slope(5);
    test::Driven from(robot.body, ground, test::Articulated());
    while (from.steps < 150) REQUIRE(from.Step());
    const Snapshot state = SnapshotOf(from);
    test::Driven to(robot.body, ground, test::Articulated());
    Set(state, false, to);
    for (int link = 0; link < to.links(); ++link) {
      const auto k = static_cast<std::size_t>(link);
      const LinkPose pose = to.engine.PoseOf(link);
      CHECK((pose.position - state.poses[k].position).norm() < 1e-12);
      CHECK((pose.axes - state.poses[k].axes).norm() < 1e-12);
      const LinkMotion motion = to.engine.MotionOf(link);
      CHECK((motion.velocity - state.motions[k].velocity).norm() < 1e-14);
      CHECK((motion.spin - state.motions[k].spin).norm() < 1e-13);
    }
    for (int joint = 0; joint < to.joints(); ++joint)
      CHECK(to.engine.JointAngle(joint) ==
            Approx(from.engine.JointAngle(joint)).margin(1e-12));
    test::Driven backwards(robot.body, ground, test::Articulated());
    Set(state, true, backwards);
    CHECK(backwards.engine.Hash() == to.engine.Hash());
  }
}

/// Every link moved and turned about by itself.
Snapshot Scattered(Snapshot state, std::mt19937& random) {
  const auto draw = [&] {
    return Vector3d(test::Uniform(random, -1, 1), test::Uniform(random, -1, 1),
                    test::Uniform(random, -1, 1));
  };
  for (LinkPose& pose : state.poses) {
    pose.position += 0.01 * draw();
    pose.axes =
        AngleAxisd(test::Uniform(random, -0.1, 0.1), draw().normalized())
            .toRotationMatrix() *
        pose.axes;
  }
  return state;
}

/// rad: the angle of a joint at which its links are turned to each other most
/// nearly as they should be, by trial.
double AngleByTrial(const Matrix3d& turned, const Vector3d& axis) {
  double best = -M_PI, most = -4;
  const auto look = [&](double from, double to, double by) {
    for (double angle = from; angle <= to; angle += by) {
      const double alike =
          (AngleAxisd(angle, axis).toRotationMatrix().transpose() * turned)
              .trace();
      if (alike > most) most = alike, best = angle;
    }
  };
  look(-M_PI, M_PI, 0.01);
  look(best - 0.01, best + 0.01, 1e-4);
  return best;
}

TEST_CASE("Poses that do not fit the joints become the nearest that do",
          "[set_state]") {
  std::mt19937 random(4);  // any
  for (int i = 0; i < 12; ++i) {
    CAPTURE(i);
    const Phenotype robot = RandomRobot(3 + i, random);
    test::Driven from(robot.body, {}, test::Articulated());
    while (from.steps < 150) REQUIRE(from.Step());
    const Snapshot state = Scattered(SnapshotOf(from), random);
    test::Driven to(robot.body, {}, test::Articulated());
    Set(state, i % 2 == 0, to);
    const LinkPose base = to.engine.PoseOf(0);
    CHECK((base.position - state.poses[0].position).norm() < 1e-12);
    CHECK((base.axes - state.poses[0].axes).norm() < 1e-12);
    CHECK(GapOfJoints(to) < 1e-12);
    for (int joint = 0; joint < to.joints(); ++joint) {
      const Hinge& hinge = to.assembly.hinges[static_cast<std::size_t>(joint)];
      const Matrix3d turned =
          state.poses[static_cast<std::size_t>(hinge.parent)].axes.transpose() *
          state.poses[static_cast<std::size_t>(hinge.child)].axes;
      CHECK(to.engine.JointAngle(joint) ==
            Approx(AngleByTrial(turned, hinge.axis)).margin(2e-4));
    }
    // And it lives on, out of the ground that it was put into.
    while (to.steps < 300) REQUIRE(to.Step());
    CHECK(GapOfJoints(to) < 1e-12);
  }
}

TEST_CASE("A state that is no number is told at the next step", "[set_state]") {
  const double none = std::nan("");
  const Vector3d zero = Vector3d::Zero();
  const LinkPose rest{{0, 0, 0.1}, Matrix3d::Identity()};
  const std::pair<LinkPose, LinkMotion> rows[] = {
      {{{none, 0, 0}, rest.axes}, {zero, zero}},
      {{{0, 0, none}, rest.axes}, {zero, zero}},
      {{rest.position, Matrix3d::Constant(none)}, {zero, zero}},
      {rest, {{0, none, 0}, zero}},
      {rest, {zero, {0, none, 0}}},
  };
  for (const auto& [pose, motion] : rows) {
    for (const int link : {0, 2}) {
      // Where it is follows from the base.
      if (link != 0 && !pose.position.allFinite()) continue;
      test::Driven robot(Cross(), {}, test::Articulated());
      robot.engine.SetState(link, pose, motion);
      CHECK_FALSE(robot.Step());
      CHECK(robot.engine.failure.outcome == Outcome::kUnstable);
    }
  }
}

}  // namespace
}  // namespace plsc
