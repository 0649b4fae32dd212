#pragma once

// The problem of one step: the motion of the base, and of those joints whose
// speed is not known beforehand, at which all forces are what their rows allow.
// A row is one force along one direction: a contact's normal, one of its two
// frictions, a servo, a joint's stop.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace plsc::articulated {

/// The two problems of a step. Friction may be mu times the normal force of
/// the first.
enum Phase : std::uint8_t {
  kPressing,  ///< without friction
  kRubbing,   ///< with all rows
};
inline constexpr int kPhases = 2;

/// Which piece of its law a row is on.
enum class Hold : std::int8_t {
  kLow = -1,  ///< the least force that it may have
  kFree = 0,  ///< in between: in proportion to what its speed lacks
  kHigh = 1,  ///< the greatest
};

/// N per m/s of a row that yields by so many m/s per N (rad/s per N m). One
/// that yields nothing would have no force of its own; it gets a hundredth of
/// what the stiffest contact yields.
inline double StiffnessOf(double yield) {
  constexpr double kLeastYield = 1e-9;
  return 1 / (yield > kLeastYield ? yield : kLeastYield);
}

/// force = (target - speed) * stiffness, cut off at low and high. N or N m, m/s
/// or rad/s; speed = offset + what the unknowns add.
struct Row {
  double offset = 0;
  double target = 0;
  double stiffness = 0;
  double low = 0, high = 0;
  Hold hold = Hold::kFree;
  double force = 0;
  double speed = 0;   ///< at the unknowns
  double change = 0;  ///< of it, along the way of a round
};

/// Where a contact's three rows act.
struct Grip {
  enum class Kind : std::uint8_t {
    kPlane,    ///< on the base, along z, x and y
    kAny,      ///< on the base, along any directions
    kBetween,  ///< between links: the base feels nothing
  };
  Kind kind = Kind::kPlane;
  Eigen::Vector3d point;                      ///< m, from the base's centre
  std::array<Eigen::Vector3d, 3> directions;  ///< unit
};

class Problem {
 public:
  static constexpr int kBase = 6;  ///< unknowns of the base: spin, velocity

  /// Of at most so many joints; memory for so many contacts at first.
  Problem(std::size_t joints, std::size_t contacts, double step);

  /// Nothing but the base, without mass.
  void Begin();
  int size() const { return size_; }
  /// Entries of the mass matrix, row >= column, and what momentum is missing.
  double& Mass(int row, int column) { return mass_[Index(row, column)]; }
  double& Aim(int row) { return aim_[static_cast<std::size_t>(row)]; }

  /// Contacts come before joints; contact i has the rows 3 i to 3 i + 2.
  void AddContact(const Grip& grip);
  std::size_t contacts() const { return grips_.size(); }
  const Grip& At(std::size_t contact) const { return grips_[contact]; }
  Row& RowAt(std::size_t row) { return rows_[row]; }
  const Row& RowAt(std::size_t row) const { return rows_[row]; }

  /// A joint's speed as one unknown more, and the rows of its servo and its
  /// stop. Mass, aim and effects on contacts are zero; its index among the
  /// unknowns.
  int AddJoint(const Row& servo, const Row& stop);
  Row& ServoOf(int unknown) { return rows_[ServoRow(unknown)]; }
  const Row& ServoOf(int unknown) const { return rows_[ServoRow(unknown)]; }
  Row& StopOf(int unknown) { return rows_[ServoRow(unknown) + 1]; }
  const Row& StopOf(int unknown) const { return rows_[ServoRow(unknown) + 1]; }
  /// m/s of a contact's row by 1 rad/s of a joint.
  void SetEffect(int unknown, std::size_t row, double effect) {
    Effects(unknown)[row] = effect;
  }

  /// Solves for the unknowns, beginning with the rows' holds. False if they
  /// were not all settled within a number of rounds; the forces are what the
  /// rows give at the unknowns found then.
  [[nodiscard]] bool Solve(Phase phase);

  double Unknown(int index) const {
    return unknowns_[static_cast<std::size_t>(index)];
  }
  int rounds() const { return rounds_; }  ///< of the latest Solve
  /// N or N m: by how much the forces of the latest Solve differ from what
  /// their rows give at the motion that they lead to.
  double residual() const { return residual_; }

 private:
  std::size_t Index(int row, int column) const {
    return static_cast<std::size_t>(row) * stride_ +
           static_cast<std::size_t>(column);
  }
  std::size_t ServoRow(int unknown) const {
    return 3 * grips_.size() + 2 * static_cast<std::size_t>(unknown - kBase);
  }
  double* Effects(int unknown) {
    return &effects_[static_cast<std::size_t>(unknown - kBase) * most_rows_];
  }
  const double* Effects(int unknown) const {
    return &effects_[static_cast<std::size_t>(unknown - kBase) * most_rows_];
  }
  template <typename Visit>
  void ForRows(Phase phase, const Visit& visit);

  void Newton(Phase phase);
  void FillBase(Phase phase);
  void FillJoint(Phase phase, int unknown);
  bool Settle(Phase phase);
  bool IsSolution(Phase phase);
  double StepLength(Phase phase);
  /// Adds what the unknowns do to each row to what Row::*to has.
  void AddSpeeds(Phase phase, const double* unknowns, double Row::*to);

  double step_;
  std::size_t stride_;
  std::size_t most_rows_ = 0;  ///< of contacts, with memory for effects
  int size_ = kBase;
  int rounds_ = 0;
  bool is_on_planes_ = true;  ///< all contacts that the base feels
  double residual_ = 0;
  std::vector<double> mass_, aim_;
  std::vector<Grip> grips_;
  std::vector<Row> rows_;
  std::vector<double> effects_;  ///< by joint, then by row of contacts
  std::vector<double> matrix_, next_, unknowns_;
};

}  // namespace plsc::articulated
