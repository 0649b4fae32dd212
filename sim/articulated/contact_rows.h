#pragma once

// Contacts as rows of the problem: three each, the normal and two frictions,
// with what the last step knew of them.

#include <cstdint>
#include <vector>

#include "sim/articulated/contact.h"
#include "sim/articulated/momenta.h"
#include "sim/articulated/problem.h"
#include "sim/contact_law.h"
#include "sim/options.h"

namespace plsc::articulated {

class ContactRows {
 public:
  ContactRows(const Model& model, const PhysicsOptions& physics);

  /// Rows of all contacts, as functions of the base's motion. The contacts
  /// must last until the step's end.
  void Add(const std::vector<Contact>& contacts, const State& state,
           const std::vector<LinkMomenta>& momenta, Problem& problem);
  /// As functions of a joint's speed, too, that became an unknown.
  void AddJoint(int link, int unknown, const State& state, Problem& problem);

  /// Holds as the last step left this phase.
  void Begin(Phase phase, Problem& problem);
  /// After each phase: holds are kept; after the first, friction gets limits.
  void End(Phase phase, Problem& problem);

  /// Adds each contact's impulse a second, N m and N, to `wrenches` by link.
  void AddForces(Phase phase, const Problem& problem,
                 std::vector<Spatial>& wrenches) const;

  /// Once a step: what is known of these contacts serves the next.
  void Keep();
  /// Nothing is known.
  void Forget();

 private:
  /// Of one contact: holds of its rows by phase.
  struct Known {
    std::uint64_t key = 0;
    Hold holds[kPhases][3] = {};
    bool is_new = true;
  };

  Known Recall(std::uint64_t key);

  const Model& model_;
  PhysicsOptions physics_;
  ContactLaw on_ground_, on_robot_;
  double pressing_on_ground_, pressing_on_robot_, rubbing_;  ///< stiffness
  const std::vector<Contact>* contacts_ = nullptr;
  std::vector<Known> known_, last_;
  std::size_t next_ = 0;  ///< in last_, where the next contact is likely
};

}  // namespace plsc::articulated
