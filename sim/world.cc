// A thin front: everything is the engine's but what follows from its poses.

#include "sim/world.h"

#include <cassert>
#include <cstddef>
#include <utility>

namespace plsc {
namespace {

using Eigen::Vector3d;

std::unique_ptr<Engine> MakeEngine(const Scene& scene) {
  switch (scene.options.physics.engine) {
    case EngineKind::kOde:
#ifdef PLSC_NO_ODE
      break;  // whoever asks for it is refused before
#else
      return MakeOdeEngine(scene);
#endif
    case EngineKind::kArticulated:
      return MakeArticulatedEngine(scene);
  }
  assert(false);
  return nullptr;
}

}  // namespace

bool HasOde() {
#ifdef PLSC_NO_ODE
  return false;
#else
  return true;
#endif
}

World::World(const Assembly& assembly, const Terrain& terrain,
             const SimulationOptions& options)
    : World(assembly, terrain, options,
            StartOf(assembly, terrain, options, {})) {}

World::World(const Assembly& assembly, const Terrain& terrain,
             const SimulationOptions& options, const Placement& placement)
    : links_(assembly.links),
      engine_(MakeEngine({assembly, terrain, options, placement})) {}

void World::SetJointSpeed(int joint, double speed) {
  engine_->SetJointSpeed(joint, speed);
}

void World::SetMotion(int link, const LinkMotion& motion) {
  engine_->SetMotion(link, motion);
}

void World::SetState(int link, const LinkPose& pose, const LinkMotion& motion) {
  engine_->SetState(link, pose, motion);
}

bool World::Step() {
  return engine_->Step();
}

void World::Listen(std::function<void(StepPart)> listener) {
  engine_->listener = std::move(listener);
}

const World::Failure& World::failure() const {
  return engine_->failure;
}

int World::joints() const {
  return links() - 1;
}

double World::JointAngle(int joint) const {
  return engine_->JointAngle(joint);
}

void World::TellJointSpeeds(std::vector<double>& speeds) const {
  assert(speeds.size() == static_cast<std::size_t>(joints()));
  engine_->TellJointSpeeds(speeds);
}

void World::TellJointTorques(std::vector<double>& torques) const {
  assert(torques.size() == static_cast<std::size_t>(joints()));
  engine_->TellJointTorques(torques);
}

double World::Mass() const {
  double mass = 0;
  for (const Link& link : links_) mass += link.mass;
  return mass;
}

int World::links() const {
  return static_cast<int>(links_.size());
}

LinkPose World::PoseOf(int link) const {
  return engine_->PoseOf(link);
}

LinkMotion World::MotionOf(int link) const {
  return engine_->MotionOf(link);
}

Vector3d World::CorePosition() const {
  const LinkPose pose = engine_->PoseOf(0);
  // The core's centre was the origin when the link's was its centre of mass.
  return pose.position - pose.axes * links_[0].centre;
}

Vector3d World::MassCentre() const {
  Vector3d moment = Vector3d::Zero();
  double mass = 0;
  for (int i = 0; i < links(); ++i) {
    const double share = links_[static_cast<std::size_t>(i)].mass;
    moment += share * engine_->PoseOf(i).position;
    mass += share;
  }
  return moment / mass;
}

int World::contacts() const {
  return engine_->contacts;
}

const std::vector<bool>& World::touched() const {
  return engine_->touched;
}

int World::solver_warnings() const {
  return engine_->warnings;
}

std::uint64_t World::Hash() const {
  return engine_->Hash();
}

}  // namespace plsc
