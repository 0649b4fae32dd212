// A step:
// - contacts: what touches what (collider);
// - momenta: the baseline, and what is missing of it (momenta);
// - problem: the base, joints that servos do not hold, rows (motors,
//   contact_rows);
// - pressing: solved without friction, how hard contacts press;
// - rubbing: solved with friction of at most mu times that;
// - integration: speeds, poses, damping (integration);
// - check: is this still a robot (sim/state_check).
//
// Two phases because ODE has them: its solver for dContactApprox1 fixes the
// limits of friction by the normal forces without any. After each phase servos
// that would need more than their torque become unknowns, and it is solved
// again (saturation).
//
// A state that is set from outside may not fit the joints: angles are those
// that fit best, links follow from the base. Its speeds are taken for those of
// a motion that goes on, so links keep I W - h W x I W, what ODE would.

#include "sim/articulated/articulated_engine.h"

#include "sim/articulated/integration.h"
#include "sim/fnv.h"

namespace plsc::articulated {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::size_t At(int index) {
  return static_cast<std::size_t>(index);
}

void Add(const Vector3d& vector, Fnv& hash) {
  for (int i = 0; i < 3; ++i) hash.Add(vector[i]);
}

}  // namespace

ArticulatedEngine::ArticulatedEngine(const Scene& scene)
    : Engine(scene.assembly),
      model_(scene.assembly),
      physics_(scene.options.physics),
      axes_(GroundAxes(scene.terrain)),
      fall_(axes_.transpose() * Vector3d(0, 0, -physics_.gravity)),
      collider_(scene, model_),
      rows_(model_, physics_),
      motors_(model_, scene.options),
      problem_(model_.links().size() - 1,
               ReservedContacts(model_.links().size()), physics_.step),
      momenta_(model_.links().size()),
      excess_(model_.links().size()),
      check_(scene) {
  state_.links.resize(model_.links().size());
  const Placement& at = scene.placement;
  state_.turned = Eigen::Quaterniond(Matrix3d(axes_.transpose() * at.axes));
  state_.base = axes_.transpose() * at(scene.assembly.links.front().centre);
  Place(model_, state_);
}

bool ArticulatedEngine::Step() {
  put_.clear();
  FindContacts();
  if (listener) listener(StepPart::kCollision);
  Aim(model_, state_, motors_.targets(), fall_, physics_.step, momenta_);
  SetBase();
  rows_.Add(*found_, state_, momenta_, problem_);
  motors_.Begin(*found_, {state_, momenta_, rows_, problem_});
  Solve(kPressing);
  Solve(kRubbing);
  Integrate();
  if (listener) listener(StepPart::kSolver);
  const bool is_sane = IsSane();
  if (listener) listener(StepPart::kChecks);
  return is_sane;
}

void ArticulatedEngine::FindContacts() {
  touched.assign(touched.size(), false);
  found_ = &collider_.Find(state_, turned_, touched);
  contacts = static_cast<int>(found_->size());
  report_ = {};
  for (const Contact& contact : *found_)
    if (contact.other != kGround) ++report_.self_contacts;
}

/// The base as the problem's first unknowns: its spin, then its velocity.
void ArticulatedEngine::SetBase() {
  const LinkMomenta& all = momenta_.front();
  const Vector3d& c = all.moment;
  const Symmetric& about = all.about_base;
  problem_.Begin();
  for (int row = 0; row < Problem::kBase; ++row)
    for (int column = 0; column <= row; ++column)
      problem_.Mass(row, column) = 0;
  problem_.Mass(0, 0) = about.xx;
  problem_.Mass(1, 0) = about.xy;
  problem_.Mass(1, 1) = about.yy;
  problem_.Mass(2, 0) = about.xz;
  problem_.Mass(2, 1) = about.yz;
  problem_.Mass(2, 2) = about.zz;
  problem_.Mass(3, 1) = c.z();
  problem_.Mass(3, 2) = -c.y();
  problem_.Mass(4, 0) = -c.z();
  problem_.Mass(4, 2) = c.x();
  problem_.Mass(5, 0) = c.y();
  problem_.Mass(5, 1) = -c.x();
  for (int i = 0; i < 3; ++i) {
    problem_.Mass(3 + i, 3 + i) = all.mass;
    problem_.Aim(i) = all.missing.angular[i];
    problem_.Aim(3 + i) = all.missing.linear[i];
  }
}

void ArticulatedEngine::Solve(Phase phase) {
  rows_.Begin(phase, problem_);
  motors_.BeginPhase(phase, problem_);
  bool is_settled = true;
  do {
    is_settled = problem_.Solve(phase);
    report_.rounds[phase] += problem_.rounds();
    ++report_.solves[phase];
  } while (motors_.FreeOverloaded(phase, {state_, momenta_, rows_, problem_}));
  if (!is_settled) ++warnings;
  report_.residual = problem_.residual();
  rows_.End(phase, problem_);
  motors_.EndPhase(phase, problem_);
}

void ArticulatedEngine::Integrate() {
  rows_.Keep();
  report_.free_joints = motors_.free();
  report_.overloaded = motors_.overloaded();
  const std::vector<double>* excess = nullptr;
  if (motors_.has_free()) {
    for (int link = 1; link < model_.size(); ++link)
      excess_[At(link)] = motors_.Excess(link, problem_);
    excess = &excess_;
  }
  const auto unknown = [&](int i) { return problem_.Unknown(i); };
  SetSpeeds(model_, momenta_,
            {{unknown(0), unknown(1), unknown(2)},
             {unknown(3), unknown(4), unknown(5)}},
            excess, state_);
  turned_ = Move(model_, motors_.targets(), excess, physics_.step, state_);
  Damp(physics_.damping, state_);
}

bool ArticulatedEngine::IsSane() {
  for (int link = 0; link < model_.size(); ++link) {
    const LinkState& own = state_.links[At(link)];
    const LinkMotion motion{own.velocity, own.spin};
    if (check_.IsFine(link, state_.base.z() + own.place.z(), motion)) continue;
    failure = check_.Look(link, PositionOf(link), motion);
    if (failure.outcome != Outcome::kCompleted) return false;
  }
  failure = check_.LookAtSolver(warnings);
  return failure.outcome == Outcome::kCompleted;
}

Vector3d ArticulatedEngine::PositionOf(int link) const {
  return axes_ * (state_.base + state_.links[At(link)].place);
}

void ArticulatedEngine::SetJointSpeed(int joint, double speed) {
  motors_.SetTarget(joint + 1, speed);
}

void ArticulatedEngine::SetMotion(int link, const LinkMotion& motion) {
  LinkState& own = state_.links[At(link)];
  own.velocity = axes_.transpose() * motion.velocity;
  own.spin = axes_.transpose() * motion.spin;
  CarryOn(link);
}

/// The link's momentum of spin, as if it had come to where it is at its speed.
void ArticulatedEngine::CarryOn(int link) {
  LinkState& own = state_.links[At(link)];
  const Vector3d momentum =
      TurnedOut(own.axes, model_.links()[At(link)].inertia) * own.spin;
  own.turning = momentum - physics_.step / 2 * own.spin.cross(momentum);
  own.gyration = physics_.step / 2 * own.spin.cross(momentum);
  own.carried = own.velocity;
  own.drift.setZero();
  own.bend.setZero();
}

void ArticulatedEngine::SetState(int link, const LinkPose& pose,
                                 const LinkMotion& motion) {
  if (put_.empty())
    for (const LinkState& own : state_.links) put_.push_back(own.axes);
  put_[At(link)] = axes_.transpose() * pose.axes;
  Fit(model_, put_, state_);
  Place(model_, state_);
  if (link == 0) state_.base = axes_.transpose() * pose.position;
  SetMotion(link, motion);
  // Inertias of all turned with their links.
  for (int i = 0; i < model_.size(); ++i) CarryOn(i);
  collider_.Forget();
  rows_.Forget();
  motors_.Forget();
}

double ArticulatedEngine::JointAngle(int joint) const {
  return state_.links[At(joint + 1)].angle;
}

void ArticulatedEngine::TellJointSpeeds(std::vector<double>& speeds) const {
  for (std::size_t i = 0; i < speeds.size(); ++i)
    speeds[i] = state_.links[i + 1].speed;
}

void ArticulatedEngine::TellJointTorques(std::vector<double>& torques) const {
  for (std::size_t i = 0; i < torques.size(); ++i)
    torques[i] = motors_.torques()[i + 1];
}

LinkPose ArticulatedEngine::PoseOf(int link) const {
  return {PositionOf(link), axes_ * state_.links[At(link)].axes};
}

LinkMotion ArticulatedEngine::MotionOf(int link) const {
  const LinkState& own = state_.links[At(link)];
  return {axes_ * own.velocity, axes_ * own.spin};
}

std::uint64_t ArticulatedEngine::Hash() const {
  Fnv hash;
  Add(state_.base, hash);
  for (int i = 0; i < 4; ++i) hash.Add(state_.turned.coeffs()[i]);
  for (const LinkState& link : state_.links) {
    hash.Add(link.angle);
    Add(link.velocity, hash);
    Add(link.spin, hash);
    Add(link.carried, hash);
    Add(link.drift, hash);
    Add(link.bend, hash);
    Add(link.turning, hash);
    Add(link.gyration, hash);
  }
  return hash.value();
}

}  // namespace plsc::articulated

namespace plsc {

std::unique_ptr<Engine> MakeArticulatedEngine(const Scene& scene) {
  return std::make_unique<articulated::ArticulatedEngine>(scene);
}

}  // namespace plsc
