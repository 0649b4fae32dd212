// Random problems of a step, against their conditions written once more with
// whole matrices, and against a method that goes the other way round: from the
// forces, one after the other, and not from the motion.

#include "sim/articulated/problem.h"

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/sim/articulated/uniform.h"

namespace plsc::articulated {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep = 0.005;  // s
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A problem in whole matrices.
struct Whole {
  MatrixXd mass;
  VectorXd aim;
  MatrixXd directions;  ///< a row each
  std::vector<Row> rows;
  std::vector<Grip> grips;
};

struct Kind {
  const char* why;
  Index joints = 0;
  Index contacts = 0;
  double stiffest = 1e3;  ///< N per m/s
  double friction = 1;    ///< N, limits at most
  bool is_slipless = false;
};

double Draw(std::mt19937& random, double low, double high) {
  return test::Uniform(random, low, high);
}

Vector3d DrawVector(std::mt19937& random) {
  return {Draw(random, -1, 1), Draw(random, -1, 1), Draw(random, -1, 1)};
}

Grip DrawGrip(Index joints, std::mt19937& random) {
  Grip grip;
  grip.kind = static_cast<Grip::Kind>(random() % (joints > 0 ? 3 : 2));
  grip.point = 0.2 * DrawVector(random);
  if (grip.kind == Grip::Kind::kPlane) {
    grip.directions = {Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitY()};
  } else {
    const Eigen::Matrix3d axes =
        Eigen::AngleAxisd(Draw(random, -3, 3), DrawVector(random).normalized())
            .toRotationMatrix();
    grip.directions = {axes.col(0), axes.col(1), axes.col(2)};
  }
  return grip;
}

Row DrawContactRow(const Kind& kind, bool is_normal, std::mt19937& random) {
  Row row;
  row.offset = Draw(random, -0.5, 0.5);
  row.stiffness = Draw(random, 0.1, 1) * kind.stiffest;
  if (is_normal) {
    row.target = Draw(random, 0, 0.1);
    row.high = kInfinite;
  } else {
    if (kind.is_slipless) row.stiffness = StiffnessOf(0);
    row.high = Draw(random, 0, 1) * kind.friction;
    row.low = -row.high;
  }
  return row;
}

Row DrawServo(const Kind& kind, std::mt19937& random) {
  Row row;
  row.stiffness = Draw(random, 0.1, 1) * kind.stiffest;
  row.high = Draw(random, 0, 0.5);
  row.low = -row.high;
  return row;
}

/// Half of the joints are at one; the others' rows do nothing.
Row DrawStop(const Kind& kind, std::mt19937& random) {
  Row row;
  if (random() % 2 == 0) return row;
  row.stiffness = Draw(random, 0.1, 1) * kind.stiffest;
  row.offset = Draw(random, -1, 1);
  row.high = kInfinite;
  return row;
}

/// Of a dozen points of 20 g, which turn about and move with the base and are
/// moved by joints in any way.
MatrixXd DrawMass(Index size, std::mt19937& random) {
  MatrixXd mass = MatrixXd::Zero(size, size);
  for (int point = 0; point < 12; ++point) {
    const Vector3d r = 0.1 * DrawVector(random);
    MatrixXd moved(3, size);
    moved.leftCols(3) << 0, r.z(), -r.y(), -r.z(), 0, r.x(), r.y(), -r.x(), 0;
    moved.middleCols(3, 3).setIdentity();
    for (Index joint = 6; joint < size; ++joint)
      moved.col(joint) = 0.1 * DrawVector(random);
    mass += 0.02 * moved.transpose() * moved;
  }
  return mass;
}

Whole DrawProblem(const Kind& kind, std::mt19937& random) {
  const Index size = Problem::kBase + kind.joints;
  Whole whole;
  whole.mass = DrawMass(size, random);
  VectorXd most = VectorXd::Constant(size, 1e-3);  // of a robot's momentum
  most.segment(3, 3).setConstant(0.05);
  whole.aim = VectorXd::NullaryExpr(
      size, [&](Index i) { return most[i] * Draw(random, -1, 1); });
  const Index of_contacts = 3 * kind.contacts;
  whole.directions = MatrixXd::Zero(of_contacts + 2 * kind.joints, size);
  for (Index i = 0; i < kind.contacts; ++i) {
    const Grip grip = DrawGrip(kind.joints, random);
    whole.grips.push_back(grip);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index row = 3 * i + static_cast<Index>(k);
      whole.rows.push_back(DrawContactRow(kind, k == 0, random));
      if (grip.kind != Grip::Kind::kBetween)
        whole.directions.row(row).head(6)
            << grip.point.cross(grip.directions[k]).transpose(),
            grip.directions[k].transpose();
      for (Index joint = 6; joint < size; ++joint)
        if (random() % 2 == 0)
          whole.directions(row, joint) = Draw(random, -0.1, 0.1);
    }
  }
  for (Index joint = 0; joint < kind.joints; ++joint) {
    whole.rows.push_back(DrawServo(kind, random));
    whole.rows.push_back(DrawStop(kind, random));
    whole.directions(of_contacts + 2 * joint, 6 + joint) = 1;
    whole.directions(of_contacts + 2 * joint + 1, 6 + joint) = 1;
  }
  return whole;
}

void Hand(const Whole& whole, Problem& problem) {
  problem.Begin();
  for (int r = 0; r < Problem::kBase; ++r) {
    for (int c = 0; c <= r; ++c) problem.Mass(r, c) = whole.mass(r, c);
    problem.Aim(r) = whole.aim[r];
  }
  for (const Grip& grip : whole.grips) problem.AddContact(grip);
  const std::size_t of_contacts = 3 * whole.grips.size();
  for (std::size_t row = 0; row < of_contacts; ++row)
    problem.RowAt(row) = whole.rows[row];
  for (std::size_t row = of_contacts; row < whole.rows.size(); row += 2) {
    const int unknown = problem.AddJoint(whole.rows[row], whole.rows[row + 1]);
    for (int c = 0; c <= unknown; ++c)
      problem.Mass(unknown, c) = whole.mass(unknown, c);
    problem.Aim(unknown) = whole.aim[unknown];
    for (std::size_t i = 0; i < of_contacts; ++i)
      problem.SetEffect(unknown, i,
                        whole.directions(static_cast<Index>(i), unknown));
  }
}

bool IsIn(const Whole& whole, Index row, Phase phase) {
  return phase == kRubbing || row % 3 == 0 ||
         row >= 3 * static_cast<Index>(whole.grips.size());
}

VectorXd MotionOf(const Problem& problem) {
  VectorXd motion(problem.size());
  for (int i = 0; i < problem.size(); ++i) motion[i] = problem.Unknown(i);
  return motion;
}

double LawOf(const Row& row, double speed) {
  return std::clamp((row.target - speed) * row.stiffness, row.low, row.high);
}

/// N or N m, by how much the problem's forces differ from their laws at its
/// motion, and N s, by how much momentum is not what forces make of it.
std::pair<double, double> Wrong(const Whole& whole, Phase phase,
                                const Problem& problem) {
  const VectorXd motion = MotionOf(problem);
  VectorXd momentum = whole.aim - whole.mass * motion;
  double off = 0;
  for (Index row = 0; row < whole.directions.rows(); ++row) {
    if (!IsIn(whole, row, phase)) continue;
    const Row& law = whole.rows[static_cast<std::size_t>(row)];
    const double force = problem.RowAt(static_cast<std::size_t>(row)).force;
    const double speed = law.offset + whole.directions.row(row).dot(motion);
    off = std::max(off, std::abs(force - LawOf(law, speed)));
    momentum += kStep * force * whole.directions.row(row).transpose();
  }
  return {off, momentum.cwiseAbs().maxCoeff()};
}

/// The motion by sweeps over the forces, each made to fit its law while all
/// others wait (Gauss and Seidel on the Delassus matrix).
VectorXd MotionBySweeps(const Whole& whole, Phase phase) {
  if (whole.rows.empty()) return whole.mass.ldlt().solve(whole.aim);
  const MatrixXd yielding =
      kStep * whole.mass.ldlt().solve(whole.directions.transpose());
  VectorXd motion = whole.mass.ldlt().solve(whole.aim);
  VectorXd forces = VectorXd::Zero(whole.directions.rows());
  for (int sweep = 0; sweep < 3000; ++sweep) {
    double most = 0;
    for (Index row = 0; row < forces.size(); ++row) {
      if (!IsIn(whole, row, phase)) continue;
      const Row& law = whole.rows[static_cast<std::size_t>(row)];
      const double own = whole.directions.row(row).dot(yielding.col(row));
      const double speed = law.offset + whole.directions.row(row).dot(motion);
      // force = clamp((target - speed - own (force - now)) stiffness)
      const double wanted = std::clamp(
          (law.target - speed + own * forces[row]) / (1 / law.stiffness + own),
          law.low, law.high);
      motion += yielding.col(row) * (wanted - forces[row]);
      most = std::max(most, std::abs(wanted - forces[row]));
      forces[row] = wanted;
    }
    if (most < 1e-11) break;
  }
  return motion;
}

constexpr Kind kKinds[] = {
    {"free flight"},
    {"a servo in free flight", 1},
    {"one contact", 0, 1},
    {"a contact and a joint", 1, 1},
    {"two contacts", 0, 2},
    {"many contacts", 0, 6},
    {"many contacts and joints", 4, 6},
    {"joints that meet", 3, 2},
    {"no friction", 2, 4, 1e3, 0},
    {"nothing slips", 2, 4, 1e3, 1, true},
    {"no friction, and nothing slips", 2, 4, 1e3, 0, true},
};

TEST_CASE("A step's problem has the solution that forces lead to",
          "[problem]") {
  std::mt19937 random(16);  // any
  for (const Kind& kind : kKinds) {
    INFO(kind.why);
    for (int i = 0; i < 12; ++i) {
      CAPTURE(i);
      const Whole whole = DrawProblem(kind, random);
      Problem problem(4, 8, kStep);
      for (const Phase phase : {kPressing, kRubbing}) {
        CAPTURE(phase);
        Hand(whole, problem);
        REQUIRE(problem.Solve(phase));
        const auto [off, momentum] = Wrong(whole, phase, problem);
        CHECK(off < 1e-6);
        CHECK(problem.residual() < 1e-6);
        CHECK(momentum < 1e-9);
        // What is hardly seen in forces may move the robot by more: 1e-6 N
        // for 5 ms move the lightest motions drawn by 1e-5.
        if (!kind.is_slipless)
          CHECK((MotionOf(problem) - MotionBySweeps(whole, phase)).norm() <
                1e-5);
      }
    }
  }
}

TEST_CASE("Stiff problems are solved, whatever the holds they begin with",
          "[problem]") {
  // Contacts as robots have them: 3 MN per m/s.
  const Kind kinds[] = {{"a robot's contacts", 0, 8, 3e6, 2},
                        {"with joints", 4, 8, 3e6, 2},
                        {"without slip", 4, 8, 3e6, 2, true}};
  std::mt19937 random(17);  // any
  for (const Kind& kind : kinds) {
    INFO(kind.why);
    for (int i = 0; i < 40; ++i) {
      CAPTURE(i);
      Whole whole = DrawProblem(kind, random);
      Problem problem(4, 2, kStep);  // memory for fewer
      VectorXd first;
      for (int start = 0; start < 3; ++start) {
        for (Row& row : whole.rows)
          row.hold = static_cast<Hold>(static_cast<int>(random() % 3) - 1);
        // Nothing holds at an infinite force.
        for (Row& row : whole.rows)
          if (row.hold == Hold::kHigh && row.high == kInfinite)
            row.hold = Hold::kFree;
        Hand(whole, problem);
        REQUIRE(problem.Solve(kRubbing));
        const auto [off, momentum] = Wrong(whole, kRubbing, problem);
        // Speeds of 1 m/s are known to 1e-16, forces to 1e9 times that.
        CHECK(off < (kind.is_slipless ? 1e-5 : 2e-6));
        CHECK(momentum < 1e-7);
        if (start == 0) first = MotionOf(problem);
        CHECK((MotionOf(problem) - first).norm() < 1e-6);
      }
    }
  }
}

TEST_CASE("A step's problem ends for every input", "[problem]") {
  const Kind kind{"", 3, 4};
  struct Spoilt {
    const char* why;
    void (*spoil)(Whole&);
  };
  const Spoilt rows[] = {
      {"mass", [](Whole& w) { w.mass(2, 1) = kNone; }},
      // One infinite mass is none of these: what has it stays at rest.
      {"mass of a joint", [](Whole& w) { w.mass(7, 7) = kNone; }},
      {"no mass at all", [](Whole& w) { w.mass.setConstant(kNone); }},
      {"momentum", [](Whole& w) { w.aim[5] = kNone; }},
      {"infinite momentum", [](Whole& w) { w.aim[0] = kInfinite; }},
      {"speed at the first contact",
       [](Whole& w) { w.rows[0].offset = kNone; }},
      {"speed at the last", [](Whole& w) { w.rows[9].offset = kNone; }},
      {"friction", [](Whole& w) { w.rows[4].offset = kNone; }},
      {"depth", [](Whole& w) { w.rows[3].target = kNone; }},
      {"a joint's speed", [](Whole& w) { w.rows.back().offset = kNone; }},
      {"all",
       [](Whole& w) {
         w.mass.setConstant(kNone);
         w.aim.setConstant(kNone);
         w.directions.setConstant(kNone);
         for (Row& row : w.rows) row.offset = row.target = kNone;
       }},
  };
  std::mt19937 random(18);  // any
  for (const Spoilt& row : rows) {
    INFO(row.why);
    Whole whole = DrawProblem(kind, random);
    row.spoil(whole);
    Problem problem(4, 8, kStep);
    Hand(whole, problem);
    CHECK_FALSE(problem.Solve(kRubbing));
    // The next is as if nothing had been.
    whole = DrawProblem(kind, random);
    Hand(whole, problem);
    CHECK(problem.Solve(kRubbing));
  }
}

}  // namespace
}  // namespace plsc::articulated
