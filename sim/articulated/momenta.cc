// With r, y, a the places, anchors and hinges of sim/articulated/kinematics,
// v_k the speed that servo k holds, m and I mass and inertia of a link, V its
// velocity and W its spin, g gravity, h the step:
//
//   baseline   O_k = O_p + v_k a_k,   U_k = U_p + O_p x (y_k - r_p)
//                                          + O_k x (r_k - y_k)
//   missing    P_k = m (C + b + h g - U_k)
//              L_k = S - c - I O_k + (r_k + d_k) x m C + r_k x m (b + h g -
//              U_k)
//   composite  sums over a subtree of m, m r, I about the base, L, P
//   joint      motion (a_k, y_k x a_k); momentum F_k of its subtree at 1 rad/s;
//              aim (a_k, y_k x a_k) . (L, P) of its subtree
//
// Joints are rigid, so the unknown motion of a step, x, is the one whose
// momentum, seen by every motion that joints allow, is what is missing
// (Featherstone 2008, ch. 6: M x = p with M of composite bodies). No term of
// Coriolis stands here: momenta are in axes that do not turn.
//
// What a link carries from step to step is momentum: m C, which acts d beside
// its place, and S of its spin. They are those of the middle of the last step,
// the way that it really went, round arcs, by the step: C = V - b with the bend
// b = (r + h V - r') / h, half a step of the pull towards the joints, and
// S = I W + c with c = h/2 W x S, half a step of the gyroscopic torque. Next
// step the momentum is sought at which the new way, bent likewise, has the
// same: a step of the variational integrator (Marsden and West 2001, Discrete
// mechanics and variational integrators, for the idea), but for b and c, which
// are those of the last step turned on. As the same b and c are added and taken
// away, linear and angular momentum of free flight are kept to rounding, and
// energy to the second order. Carrying velocities instead loses the share (h
// W)^2 / 2 of the angular momentum a step.

#include "sim/articulated/momenta.h"

#include <cstddef>

namespace plsc::articulated {
namespace {

using Eigen::Vector3d;

/// m (|r|^2 1 - r r')
Symmetric OfPoint(double mass, const Vector3d& r) {
  const Vector3d m = mass * r;
  return {m.y() * r.y() + m.z() * r.z(),
          -m.x() * r.y(),
          -m.x() * r.z(),
          m.x() * r.x() + m.z() * r.z(),
          -m.y() * r.z(),
          m.x() * r.x() + m.y() * r.y()};
}

void Own(const LinkModel& link, const LinkState& state, const Vector3d& gained,
         LinkMomenta& own) {
  own.inertia = TurnedOut(state.axes, link.inertia);
  own.mass = link.mass;
  own.moment = link.mass * state.place;
  own.about_base = own.inertia;
  own.about_base += OfPoint(link.mass, state.place);
  const Vector3d carried = link.mass * state.carried;
  const Vector3d change = link.mass * (state.bend + gained - own.velocity);
  own.missing.linear = carried + change;
  own.missing.angular =
      state.turning - state.gyration - own.inertia * own.spin +
      (state.place + state.drift).cross(carried) + state.place.cross(change);
}

/// Of the links' own sums, sums of subtrees, and what their joints see.
void Compose(const Model& model, const State& state,
             std::vector<LinkMomenta>& momenta) {
  for (std::size_t k = momenta.size(); k-- > 1;) {
    LinkMomenta& own = momenta[k];
    const Vector3d& a = state.links[k].hinge;
    const Vector3d s = state.links[k].anchor.cross(a);
    own.motion = {a, s};
    own.momentum = {own.about_base * a + own.moment.cross(s),
                    own.mass * s + a.cross(own.moment)};
    own.aim = own.motion.dot(own.missing);
    LinkMomenta& below =
        momenta[static_cast<std::size_t>(model.links()[k].parent)];
    below.mass += own.mass;
    below.moment += own.moment;
    below.about_base += own.about_base;
    below.missing.angular += own.missing.angular;
    below.missing.linear += own.missing.linear;
  }
}

}  // namespace

void Aim(const Model& model, const State& state,
         const std::vector<double>& targets, const Vector3d& fall, double step,
         std::vector<LinkMomenta>& momenta) {
  const Vector3d gained = step * fall;
  momenta[0].spin.setZero();
  momenta[0].velocity.setZero();
  Own(model.links()[0], state.links[0], gained, momenta[0]);
  for (std::size_t k = 1; k < momenta.size(); ++k) {
    const auto p = static_cast<std::size_t>(model.links()[k].parent);
    const LinkState& at = state.links[k];
    LinkMomenta& own = momenta[k];
    own.spin = momenta[p].spin + targets[k] * at.hinge;
    own.velocity = momenta[p].velocity +
                   momenta[p].spin.cross(at.anchor - state.links[p].place) +
                   own.spin.cross(at.place - at.anchor);
    Own(model.links()[k], at, gained, own);
  }
  Compose(model, state, momenta);
}

double Coupling(const Model& model, const std::vector<LinkMomenta>& momenta,
                int a, int b) {
  const auto of = [&](int link) -> const LinkMomenta& {
    return momenta[static_cast<std::size_t>(link)];
  };
  if (model.Carries(a, b)) return of(a).motion.dot(of(b).momentum);
  if (model.Carries(b, a)) return of(b).motion.dot(of(a).momentum);
  return 0;
}

}  // namespace plsc::articulated
