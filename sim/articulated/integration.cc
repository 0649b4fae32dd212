// Semi-implicit, as ODE steps: speeds first, then poses at the new speeds.
//   spins       W_k = O_k + w + sum z_j a_j of the joints above
//   velocities  V_k = U_k + v + w x r_k + sum z_j a_j x (r_k - y_j)
//   angles      q += h (v + z),  the base's quaternion += h/2 w q, normalised
//   place       the mass centre moves by h P / M, exactly; the base follows
//               from where joints lead it
// To move the base by h v instead would let the mass centre of a robot that
// works its joints in free flight wander by 0.1 mm a second.

#include "sim/articulated/integration.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace plsc::articulated {
namespace {

using Eigen::Vector3d;

// m/s and rad/s, below which ODE does not damp (its manual, "Damping").
constexpr double kDampedFrom = 0.01;

// rad a step, about: beyond, what the last step bent says little of the next.
constexpr double kGentle = 0.1;

/// Of the next step: what this one bent, turned on with the link.
void Bend(double step, double rate, LinkState& own) {
  if (own.spin.squaredNorm() * step * step > kGentle * kGentle) {
    own.bend.setZero();
    own.gyration.setZero();
    return;
  }
  const Vector3d bent = rate * own.drift + own.bend;
  own.bend = bent + step * own.spin.cross(bent);
  own.gyration = step / 2 * own.spin.cross(own.turning);
}

}  // namespace

void SetSpeeds(const Model& model, const std::vector<LinkMomenta>& momenta,
               const Spatial& base, const std::vector<double>* excess,
               State& state) {
  const auto& [w, v] = base;
  for (std::size_t k = 0; k < state.links.size(); ++k) {
    LinkState& own = state.links[k];
    if (excess == nullptr || k == 0) {
      own.spin = momenta[k].spin + w;
      own.velocity = momenta[k].velocity + v + w.cross(own.place);
    } else {
      const LinkState& parent =
          state.links[static_cast<std::size_t>(model.links()[k].parent)];
      const auto p = static_cast<std::size_t>(model.links()[k].parent);
      // Beyond the baseline: the parent's, and the joint's own.
      const Vector3d beyond = parent.spin - momenta[p].spin;
      const Vector3d turning = beyond + (*excess)[k] * own.hinge;
      own.spin = momenta[k].spin + turning;
      own.velocity = momenta[k].velocity + parent.velocity -
                     momenta[p].velocity +
                     beyond.cross(own.anchor - parent.place) +
                     turning.cross(own.place - own.anchor);
    }
  }
  for (std::size_t k = 0; k < state.links.size(); ++k) {
    LinkState& own = state.links[k];
    own.turning = momenta[k].inertia * own.spin + own.gyration;
    own.carried = own.velocity - own.bend;
  }
}

double Move(const Model& model, const std::vector<double>& targets,
            const std::vector<double>* excess, double step, State& state) {
  const Vector3d w = state.links[0].spin;
  Vector3d momentum = Vector3d::Zero();
  double fastest = 0;
  for (std::size_t k = 0; k < state.links.size(); ++k) {
    LinkState& own = state.links[k];
    momentum += model.links()[k].mass * own.carried;
    own.drift = own.place + step * own.carried;  // from the base as it was
    if (k == 0) continue;
    own.speed = targets[k] + (excess ? (*excess)[k] : 0);
    own.angle += step * own.speed;
    fastest = std::max(fastest, std::abs(own.speed));
  }
  const Eigen::Quaterniond turning =
      Eigen::Quaterniond(0, w.x(), w.y(), w.z()) * state.turned;
  state.turned.coeffs() += step / 2 * turning.coeffs();
  state.turned.normalize();
  const Vector3d moment = state.moment;
  Place(model, state);
  const Vector3d moved =
      (moment - state.moment + step * momentum) / model.mass();
  state.base += moved;
  const double rate = 1 / step;
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k < state.links.size(); ++k) {
    LinkState& own = state.links[k];
    own.drift -= moved + own.place;
    Bend(step, rate, own);
    sum += model.links()[k].mass * own.bend;
  }
  // Bends are forces within the robot: none on the whole.
  const Vector3d mean = sum / model.mass();
  for (LinkState& own : state.links) own.bend -= mean;
  return step * fastest;
}

void Damp(double damping, State& state) {
  const double kept = 1 - damping;
  for (LinkState& link : state.links) {
    if (link.velocity.squaredNorm() > kDampedFrom * kDampedFrom) {
      link.velocity *= kept;
      link.carried *= kept;
    }
    if (link.spin.squaredNorm() > kDampedFrom * kDampedFrom) {
      link.spin *= kept;
      link.turning *= kept;
    }
  }
}

}  // namespace plsc::articulated
