// A contact's row along direction e at point d of link a (and of b, which it is
// pushed from): its speed is that of a's point less that of b's. With the
// baseline of sim/articulated/momenta, u0 = e . (U_a + O_a x (d - r_a)) less
// b's; by the base's motion (d x e, e) for a contact with the ground, nothing
// for one between links; by a joint that moves a: e . a_j x (d - y_j), by one
// that moves b the same subtracted.
//
// The laws are ODE's (its manual, "Contact"; contact.cpp of 0.16): the normal
// force is at least 0 and removes the share erp of the depth a step, at most
// with correcting_speed; friction aims at no speed, yields by slip, and stays
// below mu times the normal force that the first phase found, which is how
// ODE's solver treats dContactApprox1.
//
// Most contacts last for many steps, in one order. So what the last step knew
// is looked for behind what was found last.

#include "sim/articulated/contact_rows.h"

#include <algorithm>
#include <limits>

namespace plsc::articulated {
namespace {

using Eigen::Vector3d;

/// Of a point of a link at the baseline.
Vector3d SpeedOf(const State& state, const std::vector<LinkMomenta>& momenta,
                 int link, const Vector3d& point) {
  const auto k = static_cast<std::size_t>(link);
  return momenta[k].velocity +
         momenta[k].spin.cross(point - state.links[k].place);
}

Grip::Kind KindOf(const Contact& contact) {
  if (contact.other != kGround) return Grip::Kind::kBetween;
  return contact.is_on_plane ? Grip::Kind::kPlane : Grip::Kind::kAny;
}

}  // namespace

ContactRows::ContactRows(const Model& model, const PhysicsOptions& physics)
    : model_(model),
      physics_(physics),
      on_ground_(RobotOnGround(physics)),
      on_robot_(RobotOnRobot(physics)),
      pressing_on_ground_(StiffnessOf(on_ground_.cfm)),
      pressing_on_robot_(StiffnessOf(on_robot_.cfm)),
      rubbing_(StiffnessOf(physics.slip)) {
  known_.reserve(ReservedContacts(model.links().size()));
  last_.reserve(known_.capacity());
}

void ContactRows::Forget() {
  last_.clear();
  next_ = 0;
}

void ContactRows::Keep() {
  last_.swap(known_);
  next_ = 0;
}

ContactRows::Known ContactRows::Recall(std::uint64_t key) {
  for (std::size_t i = 0; i < last_.size(); ++i) {
    const std::size_t at = (next_ + i) % last_.size();
    if (last_[at].key != key) continue;
    next_ = at + 1;
    return last_[at];
  }
  Known nothing;
  nothing.key = key;
  return nothing;
}

void ContactRows::Add(const std::vector<Contact>& contacts, const State& state,
                      const std::vector<LinkMomenta>& momenta,
                      Problem& problem) {
  contacts_ = &contacts;
  known_.clear();
  for (const Contact& contact : contacts) {
    known_.push_back(Recall(contact.key));
    Vector3d speed = SpeedOf(state, momenta, contact.link, contact.point);
    if (contact.other != kGround)
      speed -= SpeedOf(state, momenta, contact.other, contact.point);
    const std::size_t first = 3 * problem.contacts();
    problem.AddContact({KindOf(contact), contact.point, contact.directions});
    const double pressing =
        contact.other == kGround ? pressing_on_ground_ : pressing_on_robot_;
    for (std::size_t i = 0; i < 3; ++i) {
      Row& row = problem.RowAt(first + i);
      row.offset = contact.directions[i].dot(speed);
      row.stiffness = i == 0 ? pressing : rubbing_;
    }
    Row& normal = problem.RowAt(first);
    const double depth = std::max(contact.depth - physics_.surface_layer, 0.0);
    normal.target =
        std::min((contact.other == kGround ? on_ground_ : on_robot_).erp *
                     depth / physics_.step,
                 physics_.correcting_speed);
    normal.high = std::numeric_limits<double>::infinity();
  }
}

void ContactRows::AddJoint(int link, int unknown, const State& state,
                           Problem& problem) {
  const LinkState& joint = state.links[static_cast<std::size_t>(link)];
  for (std::size_t i = 0; i < contacts_->size(); ++i) {
    const Contact& contact = (*contacts_)[i];
    const bool moves = model_.Carries(link, contact.link);
    const bool moves_other =
        contact.other != kGround && model_.Carries(link, contact.other);
    if (moves == moves_other) continue;  // both: they stay as they are
    Vector3d speed = joint.hinge.cross(contact.point - joint.anchor);
    if (moves_other) speed = -speed;
    for (std::size_t row = 0; row < 3; ++row)
      problem.SetEffect(unknown, 3 * i + row,
                        contact.directions[row].dot(speed));
  }
}

void ContactRows::Begin(Phase phase, Problem& problem) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Known& known = known_[i];
    if (known.is_new && phase == kRubbing) continue;  // as the first left it
    for (std::size_t row = 0; row < 3; ++row)
      problem.RowAt(3 * i + row).hold = known.holds[phase][row];
  }
}

void ContactRows::End(Phase phase, Problem& problem) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    Known& known = known_[i];
    const double normal = problem.RowAt(3 * i).force;
    for (std::size_t row = 0; row < 3; ++row) {
      Row& own = problem.RowAt(3 * i + row);
      known.holds[phase][row] = own.hold;
      if (phase == kPressing && row > 0) {
        own.high = physics_.friction * normal;
        own.low = -own.high;
      }
    }
    if (phase == kRubbing) known.is_new = false;
  }
}

void ContactRows::AddForces(Phase phase, const Problem& problem,
                            std::vector<Spatial>& wrenches) const {
  for (std::size_t i = 0; i < contacts_->size(); ++i) {
    const Contact& contact = (*contacts_)[i];
    Vector3d force = problem.RowAt(3 * i).force * contact.directions[0];
    if (phase == kRubbing)
      force += problem.RowAt(3 * i + 1).force * contact.directions[1] +
               problem.RowAt(3 * i + 2).force * contact.directions[2];
    const Vector3d torque = contact.point.cross(force);
    Spatial& own = wrenches[static_cast<std::size_t>(contact.link)];
    own.angular += torque;
    own.linear += force;
    if (contact.other == kGround) continue;
    Spatial& other = wrenches[static_cast<std::size_t>(contact.other)];
    other.angular -= torque;
    other.linear -= force;
  }
}

}  // namespace plsc::articulated
