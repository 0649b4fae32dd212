#pragma once

// ODE's objects and what collisions need, for the two sources of this room:
// the steps and the contacts. Engine is the interface, so all is in the open.

#include <ode/ode.h>

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/contact_law.h"
#include "sim/engine.h"
#include "sim/height_field.h"
#include "sim/ode/solver_order.h"
#include "sim/overlap.h"
#include "sim/state_check.h"
#include "sim/static_boxes.h"

namespace plsc {

inline Eigen::Vector3d ToVector(const dReal* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// ODE's rotations are 3 rows of 4.
inline Eigen::Matrix3d ToMatrix(const dReal* numbers) {
  return Eigen::Map<const Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>>(numbers)
      .leftCols<3>();
}

inline void FillMatrix(const Eigen::Matrix3d& from, dMatrix3 to) {
  Eigen::Map<Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>>(to).leftCols<3>() =
      from;
}

/// Where a hinge is before a step, and what it does in it.
struct HingeLoad {
  Eigen::Vector3d axis;
  Eigen::Vector3d arm;  ///< m, from the child's centre of mass to the anchor
  dJointFeedback feedback = {};
};

struct OdeEngine final : Engine {
  dWorldID world = nullptr;
  dThreadingImplementationID threading = nullptr;
  dJointGroupID group = nullptr;
  std::vector<dBodyID> bodies;
  std::vector<dJointID> hinges;
  std::vector<std::vector<dGeomID>> geoms;  ///< by link; empty if unused
  dGeomID obstacle = nullptr;  ///< of any box of the ground, in turn

  std::vector<Link> links;  ///< in the rest pose
  std::vector<LinkCorners> corners;
  std::vector<LinkPair> pairs;
  std::vector<GroundContact> found, upright, leaning;  ///< kept for memory
  std::vector<StaticBox> boxes_near;                   ///< kept for memory
  Terrain terrain;
  Eigen::Vector3d ground;  ///< normal
  std::optional<HeightField> field;
  std::vector<HingeLoad> loads;  ///< by joint
  bool has_boxes = false;
  PhysicsOptions physics;
  ContactLaw on_ground, on_robot;
  SolverOrder order;
  bool is_direct = true;
  bool is_lost = false;  ///< interrupted within a step
  StateCheck check;

  explicit OdeEngine(const Scene& scene);
  ~OdeEngine() override;

  void SetJointSpeed(int joint, double speed) override;
  void SetMotion(int link, const LinkMotion& motion) override;
  void SetState(int link, const LinkPose& pose,
                const LinkMotion& motion) override;
  bool Step() override;
  double JointAngle(int joint) const override;
  void TellJointSpeeds(std::vector<double>& speeds) const override;
  void TellJointTorques(std::vector<double>& torques) const override;
  LinkPose PoseOf(int link) const override;
  LinkMotion MotionOf(int link) const override;
  std::uint64_t Hash() const override;

  void AddBody(const Link& link, const Placement& placement);
  void AddHinge(const Hinge& hinge, const Placement& placement,
                const ServoOptions& servo);
  void AddGeoms(const Link& link, dBodyID body);

  /// Where the servos' torques are found after a step: joints move in it.
  void NoteLoads();
  void CollideGround(std::size_t link);
  void CollideRough(std::size_t link);
  void CollideObstacles(std::size_t link);
  void CollideObstacle(std::size_t link, std::size_t box,
                       const StaticBox& other);
  void Push(std::size_t link, const FewContacts& points);
  void CollideLinks(std::size_t a, std::size_t b);
  void CollideBoxes(std::size_t a, std::size_t b, std::size_t box_a,
                    std::size_t box_b);
  void AddContact(const dContactGeom& geometry, const ContactLaw& law,
                  dBodyID first, dBodyID second);
  void Collide();
  bool IsSane();
};

}  // namespace plsc
