// With M the mass matrix, p the missing momentum, h the step, J the direction
// of a row, u = u0 + J x its speed, b its target, c its yield and l its force:
//
//   M x = p + h sum J' l,     l = clamp((b - u) / c, low, high)
//
// Forces fall as speeds rise, so this is where the gradient of a strictly
// convex, piecewise quadratic function of x vanishes: there is one solution
// (Stewart and Trinkle 1996 for the steps in velocities and impulses; Todorov,
// MuJoCo's documentation, "Computation", for the convex form of soft contacts).
// The compliance c is ODE's constraint force mixing, as its manual has it.
//
// Newton's method: with the piece that each row is on taken as known (hold), x
// is a linear system,
//
//   (M + h sum_free J'J / c) x = p + h sum_free J' (b - u0) / c
//                                  + h sum_held J' bound,
//
// solved by LDL'. If every row then is on the piece that was taken, x is exact;
// else the pieces are those at x, and again. Holds of the last step are nearly
// always right: 1.1 rounds a step. Where they go in circles, from the fifth
// round on, each goes only as far along its direction as the function falls,
// found by its slope, which ends for every start.
//
// A contact acts on the base at one point d along three directions e, so its
// rows (d x e, e) share K = sum e e' / c, and add K, [d]K and -[d]K[d]: on the
// plane K is diagonal, and all of it some 20 products. Joints' columns are few,
// and most of their effects zero.

#include "sim/articulated/problem.h"

#include <algorithm>
#include <cmath>

#include "sim/articulated/linear_system.h"

namespace plsc::articulated {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// N or N m that a force may differ from its law: a thousandth of what holds a
// plate of 1 g up, far above rounding (1e-8).
constexpr double kSettled = 1e-6;
constexpr int kPlainRounds = 4;
// Robots of 15 modules never took 60; chains of 200 joints, all overloaded,
// took one a row, four at worst.
constexpr int kMostRounds = 60;
constexpr int kRoundsARow = 10;
// Of the slope at the start of a way, what may be left at its end; a quick look
// first, which mostly does. Later to the piece on which the function is least:
// a servo's is 4e-6 rad/s wide, and a way that ends beside it has the next one
// jump to its other side, and back.
constexpr int kQuickRounds = 12;
constexpr double kSlopeLeft = 0.01;
constexpr double kLittleSlopeLeft = 1e-9;
constexpr int kMostCuts = 100;

double ForceAt(const Row& row, double speed) {
  return std::clamp((row.target - speed) * row.stiffness, row.low, row.high);
}

double Bound(const Row& row) {
  return row.hold == Hold::kLow ? row.low : row.high;
}

/// What a row adds to the linear system: `weight` to the matrix along its
/// direction, `pull` to the right side; both times the step.
struct Share {
  double weight = 0;
  double pull = 0;
};

Share ShareOf(const Row& row) {
  if (row.hold != Hold::kFree) return {0, Bound(row)};
  return {row.stiffness, row.stiffness * (row.target - row.offset)};
}

/// Sums over contacts with the ground of K, [d] K, -[d] K [d], of pulls and of
/// their moments; the symmetric ones' lower halves.
struct BaseSums {
  Matrix3d linear = Matrix3d::Zero();
  Matrix3d mixed = Matrix3d::Zero();  ///< rows: velocity, columns: spin
  Matrix3d angular = Matrix3d::Zero();
  Vector3d pull = Vector3d::Zero();
  Vector3d moment = Vector3d::Zero();

  /// On the plane, along z: (d_y, -d_x, 0; 0, 0, 1).
  void AddNormal(const Vector3d& d, const Share& z) {
    const double kx = z.weight * d.x(), ky = z.weight * d.y();
    linear(2, 2) += z.weight;
    mixed(2, 0) += ky;
    mixed(2, 1) -= kx;
    angular(0, 0) += ky * d.y();
    angular(1, 0) -= kx * d.y();
    angular(1, 1) += kx * d.x();
    pull.z() += z.pull;
    moment.x() += z.pull * d.y();
    moment.y() -= z.pull * d.x();
  }

  /// Likewise along x, (0, d_z, -d_y; 1, 0, 0), and y, (-d_z, 0, d_x; 0, 1, 0).
  void AddFriction(const Vector3d& d, const Share& x, const Share& y) {
    const double xy = x.weight * d.y(), xz = x.weight * d.z();
    const double yx = y.weight * d.x(), yz = y.weight * d.z();
    linear(0, 0) += x.weight;
    linear(1, 1) += y.weight;
    mixed(0, 1) += xz;
    mixed(0, 2) -= xy;
    mixed(1, 0) -= yz;
    mixed(1, 2) += yx;
    angular(0, 0) += yz * d.z();
    angular(1, 1) += xz * d.z();
    angular(2, 0) -= yz * d.x();
    angular(2, 1) -= xz * d.y();
    angular(2, 2) += yx * d.x() + xy * d.y();
    pull.x() += x.pull;
    pull.y() += y.pull;
    moment.x() -= y.pull * d.z();
    moment.y() += x.pull * d.z();
    moment.z() += y.pull * d.x() - x.pull * d.y();
  }

  void AddRow(const Vector3d& d, const Vector3d& e, const Share& share) {
    const Vector3d turn = d.cross(e);
    linear += share.weight * e * e.transpose();
    mixed += share.weight * e * turn.transpose();
    angular += share.weight * turn * turn.transpose();
    pull += share.pull * e;
    moment += share.pull * turn;
  }
};

}  // namespace

Problem::Problem(std::size_t joints, std::size_t contacts, double step)
    : step_(step), stride_(joints + kBase), most_rows_(3 * contacts) {
  mass_.resize(stride_ * stride_);
  matrix_.resize(stride_ * stride_);
  aim_.resize(stride_);
  next_.resize(stride_);
  unknowns_.resize(stride_);
  grips_.reserve(contacts);
  rows_.reserve(most_rows_ + 2 * joints);
  effects_.resize(joints * most_rows_);
}

void Problem::Begin() {
  size_ = kBase;
  is_on_planes_ = true;
  grips_.clear();
  rows_.clear();
  std::fill_n(unknowns_.begin(), kBase, 0.0);
}

void Problem::AddContact(const Grip& grip) {
  grips_.push_back(grip);
  if (grip.kind == Grip::Kind::kAny) is_on_planes_ = false;
  rows_.resize(3 * grips_.size());
  if (rows_.size() <= most_rows_) return;
  // More than any robot was seen to have: no effects are filed as yet.
  most_rows_ *= 2;
  effects_.resize((stride_ - kBase) * most_rows_);
}

int Problem::AddJoint(const Row& servo, const Row& stop) {
  const int index = size_++;
  std::fill_n(&mass_[Index(index, 0)], size_, 0.0);
  Aim(index) = 0;
  unknowns_[static_cast<std::size_t>(index)] = 0;
  std::fill_n(Effects(index), 3 * grips_.size(), 0.0);
  rows_.push_back(servo);
  rows_.push_back(stop);
  return index;
}

/// Those in the phase, in their order.
template <typename Visit>
void Problem::ForRows(Phase phase, const Visit& visit) {
  const std::size_t of_contacts = 3 * grips_.size();
  const std::size_t every = phase == kPressing ? 3 : 1;
  for (std::size_t row = 0; row < of_contacts; row += every) visit(rows_[row]);
  for (std::size_t row = of_contacts; row < rows_.size(); ++row)
    visit(rows_[row]);
}

bool Problem::Solve(Phase phase) {
  const int most = kMostRounds + kRoundsARow * static_cast<int>(rows_.size());
  const auto n = static_cast<std::size_t>(size_);
  bool is_settled = false;
  for (rounds_ = 1; rounds_ <= most && !is_settled; ++rounds_) {
    Newton(phase);
    const double way = rounds_ > kPlainRounds ? StepLength(phase) : 1;
    if (way == 1) {
      std::copy_n(next_.begin(), n, unknowns_.begin());
    } else {
      for (std::size_t i = 0; i < n; ++i)
        unknowns_[i] += way * (next_[i] - unknowns_[i]);
    }
    is_settled = Settle(phase) && way == 1;
  }
  --rounds_;
  ForRows(phase, [](Row& row) { row.force = ForceAt(row, row.speed); });
  return is_settled;
}

/// The motion at which each row is on the piece that it is held to.
void Problem::Newton(Phase phase) {
  FillBase(phase);
  for (int unknown = kBase; unknown < size_; ++unknown)
    FillJoint(phase, unknown);
  if (size_ == kBase && is_on_planes_) {
    SolveOfBase(matrix_.data(), stride_, next_.data());
  } else {
    SolveSystem(size_, matrix_.data(), stride_, next_.data());
  }
}

void Problem::FillBase(Phase phase) {
  BaseSums sums;
  for (std::size_t i = 0; i < grips_.size(); ++i) {
    const Grip& grip = grips_[i];
    const Row* const rows = &rows_[3 * i];
    if (grip.kind == Grip::Kind::kBetween) continue;
    const Share normal = ShareOf(rows[0]);
    if (grip.kind == Grip::Kind::kPlane) {
      sums.AddNormal(grip.point, normal);
      if (phase == kRubbing)
        sums.AddFriction(grip.point, ShareOf(rows[1]), ShareOf(rows[2]));
      continue;
    }
    sums.AddRow(grip.point, grip.directions[0], normal);
    if (phase == kPressing) continue;
    sums.AddRow(grip.point, grip.directions[1], ShareOf(rows[1]));
    sums.AddRow(grip.point, grip.directions[2], ShareOf(rows[2]));
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c <= r; ++c) {
      matrix_[Index(r, c)] = mass_[Index(r, c)] + step_ * sums.angular(r, c);
      matrix_[Index(3 + r, 3 + c)] =
          mass_[Index(3 + r, 3 + c)] + step_ * sums.linear(r, c);
    }
    for (int c = 0; c < 3; ++c)
      matrix_[Index(3 + r, c)] =
          mass_[Index(3 + r, c)] + step_ * sums.mixed(r, c);
    next_[static_cast<std::size_t>(r)] = Aim(r) + step_ * sums.moment[r];
    next_[3 + static_cast<std::size_t>(r)] = Aim(3 + r) + step_ * sums.pull[r];
  }
}

void Problem::FillJoint(Phase phase, int unknown) {
  double* const own = &matrix_[Index(unknown, 0)];
  std::copy_n(&mass_[Index(unknown, 0)], unknown + 1, own);
  double& right = next_[static_cast<std::size_t>(unknown)];
  const Share servo = ShareOf(ServoOf(unknown));
  const Share stop = ShareOf(StopOf(unknown));
  right = Aim(unknown) + step_ * (servo.pull + stop.pull);
  own[unknown] += step_ * (servo.weight + stop.weight);
  const double* const effects = Effects(unknown);
  const std::size_t every = phase == kPressing ? 3 : 1;
  for (std::size_t row = 0; row < 3 * grips_.size(); row += every) {
    if (effects[row] == 0) continue;
    const Share share = ShareOf(rows_[row]);
    right += step_ * share.pull * effects[row];
    if (share.weight == 0) continue;
    const double scaled = step_ * share.weight * effects[row];
    const Grip& grip = grips_[row / 3];
    if (grip.kind != Grip::Kind::kBetween) {
      const Vector3d& e = grip.directions[row % 3];
      const Vector3d turn = grip.point.cross(e);
      for (int i = 0; i < 3; ++i) {
        own[i] += scaled * turn[i];
        own[3 + i] += scaled * e[i];
      }
    }
    for (int other = kBase; other <= unknown; ++other)
      own[other] += scaled * Effects(other)[row];
  }
}

void Problem::AddSpeeds(Phase phase, const double* unknowns, double Row::*to) {
  const Vector3d w(unknowns[0], unknowns[1], unknowns[2]);
  const Vector3d v(unknowns[3], unknowns[4], unknowns[5]);
  for (std::size_t i = 0; i < grips_.size(); ++i) {
    const Grip& grip = grips_[i];
    Row* const rows = &rows_[3 * i];
    if (grip.kind == Grip::Kind::kBetween) continue;
    const Vector3d speed = v + w.cross(grip.point);
    if (grip.kind == Grip::Kind::kPlane) {
      rows[0].*to += speed.z();
      rows[1].*to += speed.x();
      rows[2].*to += speed.y();
    } else {
      for (std::size_t k = 0; k < 3; ++k)
        rows[k].*to += grip.directions[k].dot(speed);
    }
  }
  const std::size_t every = phase == kPressing ? 3 : 1;
  for (int unknown = kBase; unknown < size_; ++unknown) {
    const double* const effects = Effects(unknown);
    const double turn = unknowns[unknown];
    for (std::size_t row = 0; row < 3 * grips_.size(); row += every)
      rows_[row].*to += effects[row] * turn;
    ServoOf(unknown).*to += turn;
    StopOf(unknown).*to += turn;
  }
}

/// Speeds at the unknowns; whether all forces are what was taken. Holds become
/// those at these speeds.
bool Problem::Settle(Phase phase) {
  for (Row& row : rows_) row.speed = row.offset;
  AddSpeeds(phase, unknowns_.data(), &Row::speed);
  residual_ = 0;
  ForRows(phase, [&](Row& row) {
    const double force = (row.target - row.speed) * row.stiffness;
    const double taken = row.hold == Hold::kFree ? force : Bound(row);
    row.hold = force < row.low    ? Hold::kLow
               : force > row.high ? Hold::kHigh
                                  : Hold::kFree;
    const double given = row.hold == Hold::kFree ? force : Bound(row);
    const double off = std::abs(taken - given);
    if (!(off <= residual_)) residual_ = off;  // what is no number is off, too
  });
  return residual_ < kSettled;
}

/// Whether `next_` is, with all rows on the pieces that were taken. Near the
/// solution slopes are too small to tell.
bool Problem::IsSolution(Phase phase) {
  double most = 0;
  ForRows(phase, [&](const Row& row) {
    const double force = (row.target - row.speed - row.change) * row.stiffness;
    const double taken = row.hold == Hold::kFree ? force : Bound(row);
    most =
        std::max(most, std::abs(taken - std::clamp(force, row.low, row.high)));
  });
  return most < kSettled;
}

/// How far to go from the unknowns to `next_`: to where the function's slope
/// along the way is nearly nothing.
double Problem::StepLength(Phase phase) {
  const auto n = static_cast<std::size_t>(size_);
  double at_start = 0, per_way = 0;
  for (std::size_t r = 0; r < n; ++r) {
    double here = -aim_[r], change = 0;
    for (std::size_t c = 0; c < n; ++c) {
      const double mass =
          c <= r ? mass_[r * stride_ + c] : mass_[c * stride_ + r];
      here += mass * unknowns_[c];
      change += mass * (next_[c] - unknowns_[c]);
    }
    at_start += (next_[r] - unknowns_[r]) * here;
    per_way += (next_[r] - unknowns_[r]) * change;
  }
  for (Row& row : rows_) row.change = row.offset - row.speed;
  AddSpeeds(phase, next_.data(), &Row::change);
  if (IsSolution(phase)) return 1;
  const auto slope = [&](double way) {
    double sum = at_start + way * per_way;
    ForRows(phase, [&](const Row& row) {
      sum -= step_ * row.change * ForceAt(row, row.speed + way * row.change);
    });
    return sum;
  };
  const double enough =
      (rounds_ > kQuickRounds ? kLittleSlopeLeft : kSlopeLeft) *
      std::abs(slope(0));
  double low = 0, high = 1;
  double at_low = slope(0), at_high = slope(1);
  if (std::abs(at_high) <= enough || !(at_high > 0)) return 1;
  // The slope rises from below zero to above: regula falsi, the stale end's
  // slope halved (Illinois).
  double way = 1;
  for (int cut = 0; cut < kMostCuts; ++cut) {
    way = (low * at_high - high * at_low) / (at_high - at_low);
    const double here = slope(way);
    if (std::abs(here) <= enough) break;
    if (here > 0) {
      high = way, at_high = here;
      at_low /= 2;
    } else {
      low = way, at_low = here;
      at_high /= 2;
    }
  }
  return way;
}

}  // namespace plsc::articulated
