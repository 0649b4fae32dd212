// With R_k the axes of link k as columns, p its parent, q its angle and s the
// sign of its hinge along axis i of the grid (Featherstone, Rigid Body Dynamics
// Algorithms, 2008, ch. 4, in one frame for all):
//   hinge   a_k = s R_p e_i
//   anchor  y_k = r_p + R_p anchor
//   axes    R_k = R_p turn(e_i, s q): column i is kept, the next two turn
//   place   r_k = y_k + R_k arm
// One pass from the base outward, 18 multiplications a rotation.

#include "sim/articulated/kinematics.h"

#include <cmath>
#include <cstddef>

#include "sim/maths/arc.h"
#include "sim/maths/sine.h"

namespace plsc::articulated {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Symmetric TurnedOut(const Matrix3d& axes, const Matrix3d& inertia) {
  const Matrix3d half = axes * inertia;
  const auto entry = [&](int row, int column) {
    return half(row, 0) * axes(column, 0) + half(row, 1) * axes(column, 1) +
           half(row, 2) * axes(column, 2);
  };
  return {entry(0, 0), entry(0, 1), entry(0, 2),
          entry(1, 1), entry(1, 2), entry(2, 2)};
}

namespace {

/// Hinge and axes of a link that turns about axis I of its parent's.
template <int I>
void Turn(const Matrix3d& parent, double sign, LinkState& own) {
  constexpr int kNext = (I + 1) % 3, kLast = (I + 2) % 3;
  const SineCosine turn = SinCos(own.angle);
  const double s = sign * turn.sine, c = turn.cosine;
  own.hinge = sign * parent.col(I);
  own.axes.col(I) = parent.col(I);
  own.axes.col(kNext) = c * parent.col(kNext) + s * parent.col(kLast);
  own.axes.col(kLast) = c * parent.col(kLast) - s * parent.col(kNext);
}

constexpr void (*kTurns[])(const Matrix3d&, double, LinkState&) = {
    Turn<0>, Turn<1>, Turn<2>};

}  // namespace

void Place(const Model& model, State& state) {
  LinkState& base = state.links[0];
  base.axes = state.turned.toRotationMatrix();
  base.place.setZero();
  state.moment.setZero();
  for (std::size_t k = 1; k < state.links.size(); ++k) {
    const LinkModel& link = model.links()[k];
    const LinkState& parent =
        state.links[static_cast<std::size_t>(link.parent)];
    LinkState& own = state.links[k];
    kTurns[link.axis](parent.axes, link.sign, own);
    own.anchor = parent.place + parent.axes * link.anchor;
    own.place = own.anchor + own.axes * link.arm;
    state.moment += link.mass * own.place;
  }
}

void Fit(const Model& model, const std::vector<Matrix3d>& axes, State& state) {
  state.turned = Eigen::Quaterniond(axes[0]).normalized();
  for (std::size_t k = 1; k < axes.size(); ++k) {
    const LinkModel& link = model.links()[k];
    const int i = link.axis, j = (i + 1) % 3, l = (i + 2) % 3;
    const Matrix3d turn =
        axes[static_cast<std::size_t>(link.parent)].transpose() * axes[k];
    state.links[k].angle =
        link.sign * Atan2(turn(l, j) - turn(j, l), turn(j, j) + turn(l, l));
  }
}

}  // namespace plsc::articulated
