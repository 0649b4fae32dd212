// A servo strives for its target speed v with a torque of at most t (ODE's
// manual, "Stops and motor parameters"): force = clamp(-z / cfm, -t, t) where z
// is what its joint turns beyond v. ODE's cfm of 1e-5 makes z of a servo within
// its torque 2e-6 rad/s at most; here it is 0, and the joint no unknown.
//
// Whether a servo is within its torque follows from the solution: with F the
// momentum of what the joint moves at 1 rad/s, x the motion found, a.L + s.P
// the aim, W the wrench of contacts below,
//
//   t_k = ((F_k . x + sum_j M_kj z_j) - aim_k) / h - motion_k . W_k.
//
// Those beyond the limit become unknowns, held at that limit, and the problem
// is solved again. The set only grows, so this ends, at worst with all joints
// unknown, which is the full problem. Those freed this way in either phase are
// free in the next step from the start.
//
// A stop is a row beside the servo's: v = -erp / h (angle - stop), with force
// away from the stop only. ODE has one row for both: at a stop it takes the
// servo's away and gives all of its torque in the direction of the target, also
// where that leads away from the stop. That is a kick of t h / I in a step,
// which vanishes as h does: 9 rad/s of a limb, 500 of a lone plate, which is
// why some lives in ODE end as unstable. Two rows are what its authors say
// there should be (dxJointLimitMotor, "we actually need two lcp constraints").

#include "sim/articulated/motors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plsc::articulated {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

}  // namespace

Motors::Motors(const Model& model, const SimulationOptions& options)
    : model_(model), physics_(options.physics), servo_(options.servo) {
  const std::size_t n = model.links().size();
  targets_.assign(n, 0);
  torques_.assign(n, 0);
  free_of_.assign(n, -1);
  for (auto& holds : holds_) holds.assign(n, Hold::kFree);
  wrenches_.resize(n);
  free_.reserve(n);
}

void Motors::Forget() {
  for (auto& holds : holds_) std::fill(holds.begin(), holds.end(), Hold::kFree);
}

bool Motors::IsAtStop(double angle) const {
  return angle <= -servo_.range || angle >= servo_.range;
}

void Motors::Begin(const std::vector<Contact>& contacts, const Step& step) {
  for (const Free& free : free_)
    free_of_[static_cast<std::size_t>(free.link)] = -1;
  free_.clear();
  overloaded_ = 0;
  for (int link = 1; link < model_.size(); ++link) {
    const auto k = static_cast<std::size_t>(link);
    if (holds_[kPressing][k] != Hold::kFree ||
        holds_[kRubbing][k] != Hold::kFree ||
        IsAtStop(step.state.links[k].angle))
      MakeFree(link, Hold::kFree, step);
  }
  for (const Contact& contact : contacts) {
    if (contact.other == kGround) continue;
    for (int link = 1; link < model_.size(); ++link)
      if (free_of_[static_cast<std::size_t>(link)] < 0 &&
          model_.Carries(link, contact.link) !=
              model_.Carries(link, contact.other))
        MakeFree(link, Hold::kFree, step);
  }
}

void Motors::MakeFree(int link, Hold hold, const Step& step) {
  const auto k = static_cast<std::size_t>(link);
  const LinkMomenta& own = step.momenta[k];
  const double angle = step.state.links[k].angle;
  Row servo;
  servo.stiffness = StiffnessOf(physics_.world_cfm);
  servo.low = -servo_.max_torque;
  servo.high = servo_.max_torque;
  servo.hold = hold;

  Problem& problem = step.problem;
  Free free;
  free.link = link;
  free.unknown = problem.AddJoint(
      servo, IsAtStop(angle) ? StopRow(targets_[k], angle) : Row{});
  for (int i = 0; i < 3; ++i) {
    problem.Mass(free.unknown, i) = own.momentum.angular[i];
    problem.Mass(free.unknown, 3 + i) = own.momentum.linear[i];
  }
  for (const Free& other : free_)
    problem.Mass(free.unknown, other.unknown) =
        Coupling(model_, step.momenta, link, other.link);
  problem.Mass(free.unknown, free.unknown) = own.motion.dot(own.momentum);
  problem.Aim(free.unknown) = own.aim;
  step.contacts.AddJoint(link, free.unknown, step.state, problem);

  for (const Phase phase : {kPressing, kRubbing})
    free.holds[phase] = hold == Hold::kFree ? holds_[phase][k] : hold;
  free_of_[k] = static_cast<int>(free_.size());
  free_.push_back(free);
}

Row Motors::StopRow(double target, double angle) const {
  const bool is_low = angle <= -servo_.range;
  const double beyond = is_low ? angle + servo_.range : angle - servo_.range;
  Row row;
  row.stiffness = StiffnessOf(physics_.world_cfm);
  row.offset = target;
  row.target = -physics_.world_erp / physics_.step * beyond;
  row.low = is_low ? 0 : -kNoLimit;
  row.high = is_low ? kNoLimit : 0;
  return row;
}

void Motors::BeginPhase(Phase phase, Problem& problem) const {
  for (const Free& free : free_)
    problem.ServoOf(free.unknown).hold = free.holds[phase];
}

bool Motors::FreeOverloaded(Phase phase, const Step& step) {
  const Problem& problem = step.problem;
  for (Spatial& wrench : wrenches_) {
    wrench.angular.setZero();
    wrench.linear.setZero();
  }
  step.contacts.AddForces(phase, problem, wrenches_);
  const Eigen::Vector3d spin{problem.Unknown(0), problem.Unknown(1),
                             problem.Unknown(2)};
  const Eigen::Vector3d velocity{problem.Unknown(3), problem.Unknown(4),
                                 problem.Unknown(5)};
  const Spatial base{spin, velocity};
  const double rate = 1 / physics_.step;
  const std::size_t known = free_.size();
  for (std::size_t k = wrenches_.size(); k-- > 1;) {
    const LinkMomenta& own = step.momenta[k];
    Spatial& below =
        wrenches_[static_cast<std::size_t>(model_.links()[k].parent)];
    below.angular += wrenches_[k].angular;
    below.linear += wrenches_[k].linear;
    if (free_of_[k] >= 0) continue;
    const int link = static_cast<int>(k);
    double momentum = own.momentum.dot(base);
    for (std::size_t i = 0; i < known; ++i)
      momentum += Coupling(model_, step.momenta, link, free_[i].link) *
                  problem.Unknown(free_[i].unknown);
    const double torque =
        rate * (momentum - own.aim) - own.motion.dot(wrenches_[k]);
    torques_[k] = torque;
    if (torque > servo_.max_torque) MakeFree(link, Hold::kHigh, step);
    if (torque < -servo_.max_torque) MakeFree(link, Hold::kLow, step);
  }
  return free_.size() > known;
}

void Motors::EndPhase(Phase phase, const Problem& problem) {
  for (const Free& free : free_) {
    const Row& servo = problem.ServoOf(free.unknown);
    holds_[phase][static_cast<std::size_t>(free.link)] = servo.hold;
    torques_[static_cast<std::size_t>(free.link)] = servo.force;
  }
  if (phase != kRubbing) return;
  for (std::size_t k = 1; k < free_of_.size(); ++k) {
    if (free_of_[k] >= 0) {
      if (holds_[phase][k] != Hold::kFree) ++overloaded_;
      continue;
    }
    holds_[kPressing][k] = holds_[kRubbing][k] = Hold::kFree;
  }
}

double Motors::Excess(int link, const Problem& problem) const {
  const int index = free_of_[static_cast<std::size_t>(link)];
  return index < 0
             ? 0
             : problem.Unknown(free_[static_cast<std::size_t>(index)].unknown);
}

}  // namespace plsc::articulated
