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
// found to 1 % of its slope, which ends for every start. Cost: n^3 / 6 of the
// unknowns, n^2 / 2 a free row.

#include "sim/articulated/problem.h"

#include <algorithm>
#include <cmath>

namespace plsc::articulated {
namespace {

// N or N m that a force may differ from its law: a thousandth of what holds a
// plate of 1 g up, far above rounding (1e-8).
constexpr double kSettled = 1e-6;
constexpr int kPlainRounds = 4;
// Robots of 15 modules never took 60; chains of 200 joints, all overloaded, took
// one a row, four at worst.
constexpr int kMostRounds = 60;
constexpr int kRoundsARow = 10;
constexpr double kSlopeLeft = 0.01;
constexpr int kMostCuts = 40;

double ForceAt(const Row& row, double speed) {
  return std::clamp((row.target - speed) / row.yield, row.low, row.high);
}

/// On which piece the row is at a speed.
Hold HoldAt(const Row& row, double speed) {
  const double force = (row.target - speed) / row.yield;
  if (force < row.low) return Hold::kLow;
  if (force > row.high) return Hold::kHigh;
  return Hold::kFree;
}

double Bound(const Row& row) {
  return row.hold == Hold::kLow ? row.low : row.high;
}

}  // namespace

Problem::Problem(std::size_t joints, std::size_t rows, double step)
    : step_(step), stride_(joints + kBase) {
  mass_.resize(stride_ * stride_);
  matrix_.resize(stride_ * stride_);
  aim_.resize(stride_);
  next_.resize(stride_);
  unknowns_.resize(stride_);
  rows_.reserve(rows);
  speeds_.reserve(rows);
  changes_.reserve(rows);
  directions_.reserve(rows * stride_);
}

void Problem::Begin() {
  size_ = 0;
  rows_.clear();
  directions_.clear();
  for (int i = 0; i < kBase; ++i) AddUnknown();
}

int Problem::AddUnknown() {
  const int index = size_++;
  std::fill_n(&mass_[At(index, 0)], size_, 0.0);
  Aim(index) = 0;
  unknowns_[static_cast<std::size_t>(index)] = 0;
  return index;
}

std::size_t Problem::AddRow() {
  rows_.emplace_back();
  directions_.resize(directions_.size() + stride_);
  speeds_.resize(rows_.size());
  changes_.resize(rows_.size());
  return rows_.size() - 1;
}

bool Problem::Solve(const std::vector<std::uint32_t>& rows) {
  const bool is_settled =
      size_ == kBase ? SolveSized<kBase>(rows) : SolveSized<0>(rows);
  TakeForces(rows);
  return is_settled;
}

template <int N>
bool Problem::SolveSized(const std::vector<std::uint32_t>& rows) {
  const int n = N > 0 ? N : size_;
  const int most = kMostRounds + kRoundsARow * static_cast<int>(rows.size());
  for (rounds_ = 1; rounds_ <= most; ++rounds_) {
    Newton<N>(rows);
    const double way = rounds_ > kPlainRounds ? StepLength<N>(rows) : 1;
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      unknowns_[at] = way == 1
                          ? next_[at]
                          : unknowns_[at] + way * (next_[at] - unknowns_[at]);
    }
    if (Settle<N>(rows) && way == 1) return true;
  }
  return false;
}

/// The motion at which each row is on the piece that it is held to.
template <int N>
void Problem::Newton(const std::vector<std::uint32_t>& rows) {
  const int n = N > 0 ? N : size_;
  for (int r = 0; r < n; ++r) {
    for (int c = 0; c <= r; ++c) matrix_[At(r, c)] = mass_[At(r, c)];
    next_[static_cast<std::size_t>(r)] = Aim(r);
  }
  for (const std::uint32_t index : rows) {
    const Row& row = rows_[index];
    const double* const direction = &directions_[index * stride_];
    if (row.hold != Hold::kFree) {
      const double bound = Bound(row);
      if (bound == 0) continue;
      for (int r = 0; r < n; ++r)
        next_[static_cast<std::size_t>(r)] += step_ * bound * direction[r];
      continue;
    }
    const double weight = step_ / row.yield;
    const double pull = weight * (row.target - row.offset);
    for (int r = 0; r < n; ++r) {
      const double scaled = weight * direction[r];
      for (int c = 0; c <= r; ++c) matrix_[At(r, c)] += scaled * direction[c];
      next_[static_cast<std::size_t>(r)] += pull * direction[r];
    }
  }
  // L D L' in place: D on the diagonal, L below it.
  for (int r = 0; r < n; ++r) {
    double* const own = &matrix_[At(r, 0)];
    double pivot = own[r];
    for (int c = 0; c < r; ++c) {
      const double* const other = &matrix_[At(c, 0)];
      double sum = own[c];
      for (int k = 0; k < c; ++k) sum -= own[k] * other[k];
      own[c] = sum;  // L D as yet
    }
    for (int c = 0; c < r; ++c) {
      const double scaled = own[c] * matrix_[At(c, c)];
      pivot -= own[c] * scaled;
      own[c] = scaled;
    }
    own[r] = 1 / pivot;
  }
  for (int r = 0; r < n; ++r)
    for (int k = 0; k < r; ++k)
      next_[static_cast<std::size_t>(r)] -=
          matrix_[At(r, k)] * next_[static_cast<std::size_t>(k)];
  for (int r = n; r-- > 0;) {
    double& own = next_[static_cast<std::size_t>(r)];
    own *= matrix_[At(r, r)];
    for (int k = r + 1; k < n; ++k)
      own -= matrix_[At(k, r)] * next_[static_cast<std::size_t>(k)];
  }
}

/// Speeds at the unknowns; whether all forces are what was taken. Holds become
/// those at these speeds.
template <int N>
bool Problem::Settle(const std::vector<std::uint32_t>& rows) {
  const int n = N > 0 ? N : size_;
  residual_ = 0;
  for (const std::uint32_t index : rows) {
    Row& row = rows_[index];
    const double* const direction = &directions_[index * stride_];
    double speed = row.offset;
    for (int i = 0; i < n; ++i)
      speed += direction[i] * unknowns_[static_cast<std::size_t>(i)];
    speeds_[index] = speed;
    const double taken =
        row.hold == Hold::kFree ? (row.target - speed) / row.yield : Bound(row);
    const double off = std::abs(taken - ForceAt(row, speed));
    if (!(off <= residual_)) residual_ = off;  // what is no number is off, too
    row.hold = HoldAt(row, speed);
  }
  return residual_ < kSettled;
}

/// How far to go from the unknowns to `next_`: to where the function's slope
/// along the way is at most kSlopeLeft of the slope at its start.
template <int N>
double Problem::StepLength(const std::vector<std::uint32_t>& rows) {
  const int n = N > 0 ? N : size_;
  double at_start = 0, per_way = 0;
  for (int r = 0; r < n; ++r) {
    const auto i = static_cast<std::size_t>(r);
    double here = -Aim(r), change = 0;
    for (int c = 0; c < n; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const double mass = c <= r ? mass_[At(r, c)] : mass_[At(c, r)];
      here += mass * unknowns_[k];
      change += mass * (next_[k] - unknowns_[k]);
    }
    at_start += (next_[i] - unknowns_[i]) * here;
    per_way += (next_[i] - unknowns_[i]) * change;
  }
  for (const std::uint32_t index : rows) {
    const double* const direction = &directions_[index * stride_];
    double change = 0;
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      change += direction[i] * (next_[k] - unknowns_[k]);
    }
    changes_[index] = change;
  }
  const auto slope = [&](double way) {
    double sum = at_start + way * per_way;
    for (const std::uint32_t index : rows)
      sum -= step_ * changes_[index] *
             ForceAt(rows_[index], speeds_[index] + way * changes_[index]);
    return sum;
  };
  const double first = slope(0);
  const double enough = kSlopeLeft * std::abs(first);
  double low = 0, high = 1;
  double at_low = first, at_high = slope(1);
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

void Problem::TakeForces(const std::vector<std::uint32_t>& rows) {
  for (const std::uint32_t index : rows)
    rows_[index].force = ForceAt(rows_[index], speeds_[index]);
}

}  // namespace plsc::articulated
