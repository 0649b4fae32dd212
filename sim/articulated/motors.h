#pragma once

// What the servos do. A servo within its torque turns its joint at its target,
// so that joint is no unknown; those that cannot, or need not, are.

#include <cstdint>
#include <vector>

#include "sim/articulated/contact_rows.h"
#include "sim/articulated/momenta.h"
#include "sim/articulated/problem.h"
#include "sim/options.h"

namespace plsc::articulated {

class Motors {
 public:
  Motors(const Model& model, const SimulationOptions& options);

  const std::vector<double>& targets() const { return targets_; }  ///< rad/s
  void SetTarget(int link, double speed) {
    targets_[static_cast<std::size_t>(link)] = speed;
  }

  /// What motors work in.
  struct Step {
    const State& state;
    const std::vector<LinkMomenta>& momenta;
    ContactRows& contacts;
    Problem& problem;
  };

  /// Makes unknowns of the joints that have to be: those whose servo gave all
  /// it has in the last step, those at a stop, those between links that touch.
  void Begin(const std::vector<Contact>& contacts, const Step& step);
  /// Holds as the last step left this phase.
  void BeginPhase(Phase phase, Problem& problem) const;
  /// Makes unknowns of the servos that would need more torque than they have;
  /// whether there were any, so that the phase must be solved again.
  bool FreeOverloaded(Phase phase, const Step& step);
  void EndPhase(Phase phase, const Problem& problem);

  /// N m, by link: of its servo in the latest step.
  const std::vector<double>& torques() const { return torques_; }

  bool has_free() const { return !free_.empty(); }
  /// rad/s beyond its target that the joint turns at.
  double Excess(int link, const Problem& problem) const;
  /// Holds of the last step are forgotten.
  void Forget();

  /// Of the latest step: servos at their limit, joints made unknown.
  int overloaded() const { return overloaded_; }
  int free() const { return static_cast<int>(free_.size()); }

 private:
  /// A joint whose speed is unknown, and how its servo was held.
  struct Free {
    int link = 0;
    int unknown = 0;
    Hold holds[kPhases] = {};
  };

  void MakeFree(int link, Hold hold, const Step& step);
  Row StopRow(double target, double angle) const;
  bool IsAtStop(double angle) const;

  const Model& model_;
  PhysicsOptions physics_;
  ServoOptions servo_;
  std::vector<double> targets_;
  std::vector<double> torques_;
  std::vector<int> free_of_;  ///< by link: index in free_, or -1
  std::vector<Free> free_;
  std::vector<Hold> holds_[kPhases];  ///< by link, of the last step
  std::vector<Spatial> wrenches_;     ///< by link, then of subtrees
  int overloaded_ = 0;
};

}  // namespace plsc::articulated
