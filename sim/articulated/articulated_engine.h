#pragma once

// The engine of the project's own: a robot in joint coordinates on its ground,
// a step as a list of stages. docs/engine.md derives the method.

#include <cstdint>
#include <memory>
#include <vector>

#include "sim/articulated/collider.h"
#include "sim/articulated/contact_rows.h"
#include "sim/articulated/kinematics.h"
#include "sim/articulated/model.h"
#include "sim/articulated/momenta.h"
#include "sim/articulated/motors.h"
#include "sim/articulated/problem.h"
#include "sim/engine.h"
#include "sim/state_check.h"

namespace plsc::articulated {

class ArticulatedEngine final : public Engine {
 public:
  explicit ArticulatedEngine(const Scene& scene);

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

  /// What the latest step was like, for tests and benchmarks.
  struct Report {
    int rounds[kPhases] = {};  ///< of Newton's method
    int solves[kPhases] = {};  ///< as servos became unknowns
    double residual = 0;       ///< N or N m, of the last phase
    int free_joints = 0;
    int overloaded = 0;     ///< servos at their limit
    int self_contacts = 0;  ///< points between links
  };
  const Report& report() const { return report_; }

 private:
  void FindContacts();
  void SetBase();
  void Solve(Phase phase);
  void Integrate();
  bool IsSane();
  void CarryOn(int link);
  Eigen::Vector3d PositionOf(int link) const;

  Model model_;
  PhysicsOptions physics_;
  Eigen::Matrix3d axes_;  ///< of the ground, in the world
  Eigen::Vector3d fall_;  ///< m/s2, gravity in the ground's axes
  State state_;
  std::vector<Eigen::Matrix3d> put_;  ///< axes by link, while states are set
  double turned_ = 0;  ///< rad, the most of any joint in the last step
  Collider collider_;
  ContactRows rows_;
  Motors motors_;
  Problem problem_;
  std::vector<LinkMomenta> momenta_;
  std::vector<double> excess_;  ///< rad/s by link
  const std::vector<Contact>* found_ = nullptr;
  StateCheck check_;
  Report report_;
};

}  // namespace plsc::articulated
