#pragma once

// The problem of one step: the motion of the base, and of those joints whose
// speed is not known beforehand, at which all forces are what their rows allow.
// A row is one force along one direction: a contact's normal, one of its two
// frictions, a servo, a joint's stop.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace plsc::articulated {

/// Which piece of its law a row is on.
enum class Hold : std::int8_t {
  kLow = -1,  ///< the least force that it may have
  kFree = 0,  ///< in between: in proportion to what its speed lacks
  kHigh = 1,  ///< the greatest
};

/// force = (target - speed) / yield, cut off at low and high. N or N m, m/s or
/// rad/s; speed = offset + direction . unknowns.
struct Row {
  double offset = 0;
  double target = 0;
  double yield = 0;  ///< positive: m/s per N, rad/s per N m
  double low = 0, high = 0;
  Hold hold = Hold::kFree;
  double force = 0;
};

class Problem {
 public:
  static constexpr int kBase = 6;  ///< unknowns of the base: spin, velocity

  /// Of at most so many joints; memory for so many rows at first.
  Problem(std::size_t joints, std::size_t rows, double step);

  /// Nothing but the base, all zero.
  void Begin();
  /// One unknown more, of mass, aim and directions of zero; its index.
  int AddUnknown();
  int size() const { return size_; }
  /// Entries of the mass matrix, row >= column, and what momentum is missing.
  double& Mass(int row, int column) { return mass_[At(row, column)]; }
  double& Aim(int row) { return aim_[static_cast<std::size_t>(row)]; }

  /// One row more, directions zero; its index.
  std::size_t AddRow();
  std::size_t rows() const { return rows_.size(); }
  Row& At(std::size_t row) { return rows_[row]; }
  const Row& At(std::size_t row) const { return rows_[row]; }
  /// By unknown.
  double* Direction(std::size_t row) { return &directions_[row * stride_]; }

  /// Solves for the unknowns with the given rows, beginning with their holds.
  /// False if they were not all settled to kSettled in kMostRounds; the forces
  /// are what the rows give at the unknowns found then.
  [[nodiscard]] bool Solve(const std::vector<std::uint32_t>& rows);

  double Unknown(int index) const {
    return unknowns_[static_cast<std::size_t>(index)];
  }
  int rounds() const { return rounds_; }  ///< of the latest Solve
  /// N or N m: by how much the forces of the latest Solve differ from what
  /// their rows give at the motion that they lead to.
  double residual() const { return residual_; }

 private:
  std::size_t At(int row, int column) const {
    return static_cast<std::size_t>(row) * stride_ +
           static_cast<std::size_t>(column);
  }
  template <int N>
  bool SolveSized(const std::vector<std::uint32_t>& rows);
  template <int N>
  void Newton(const std::vector<std::uint32_t>& rows);
  template <int N>
  bool Settle(const std::vector<std::uint32_t>& rows);
  template <int N>
  double StepLength(const std::vector<std::uint32_t>& rows);
  void TakeForces(const std::vector<std::uint32_t>& rows);

  double step_;
  std::size_t stride_;
  int size_ = kBase;
  int rounds_ = 0;
  double residual_ = 0;
  std::vector<double> mass_, aim_, directions_;
  std::vector<Row> rows_;
  std::vector<double> speeds_, changes_;  ///< by row
  std::vector<double> matrix_, next_, unknowns_;
};

}  // namespace plsc::articulated
