// ODE, held to what a run needs of it and it does not promise: the same bits
// for the same robot, whatever else the process did; no memory asked for in a
// step; and no abort.
//
// Same bits: everything that ODE shares between worlds is replaced by the
// world's own, its threading, and the generator by which the iterative solver
// shuffles its rows (solver_order). Bodies, hinges and contacts are made in the
// order of the assembly, since the solver's sums run in the order in which
// joints were made; to add an object earlier is to change every stored run.
//
// No abort: ODE's assertions end the process where a state overflows within a
// step. Its handlers throw instead, and the world is lost: ODE cannot be taken
// down in the middle of a step, so what it left is kept until the process ends.
// After each step the state is looked at (IsSane), because a robot that
// explodes may do so for many steps before a number overflows, and would be
// fast until then.
//
// A step of the direct solver grows with the cube of a robot's links, so robots
// of more than max_direct_links get the iterative one.

#include "sim/world.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <utility>

#include "sim/fnv.h"
#include "sim/world_ode.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Thrown where ODE would abort the process: its assertions are active, and a
/// state that overflows within a step fails one.
struct OdeFailure {};

// m, that all of a link may be below the ground. A fall from 10 m ends in it:
// 70 mm a step, which the next steps stop.
constexpr double kDeepest = 0.1;

// Bytes that a world's steps have from the start. ODE's own 64 KiB grow as a
// robot meets the ground with more; this is more than 15 modules were seen to
// take (about 200 KiB), so that no step asks for memory.
constexpr unsigned kStepMemory = 1U << 18;

/// Counts for the world that this thread steps, if any.
thread_local int* warnings_in_use = nullptr;

void CountWarning(int /*number*/, const char* /*format*/, va_list /*values*/) {
  if (warnings_in_use != nullptr) ++*warnings_in_use;
}

[[noreturn]] void Fail(int /*number*/, const char* /*format*/,
                       va_list /*values*/) {
  throw OdeFailure{};
}

/// ODE's own state, shared by all worlds and never closed: threads may still
/// be stepping when the program ends.
void OpenOde() {
  [[maybe_unused]] static const bool is_open = [] {
    dInitODE2(0);
    dSetMessageHandler(CountWarning);
    dSetErrorHandler(Fail);
    dSetDebugHandler(Fail);
    return true;
  }();
}

}  // namespace

World::Ode::Ode(const Assembly& assembly, const Terrain& on,
                const SimulationOptions& options, const Placement& placement)
    : links(assembly.links),
      pairs(CollidingPairs(assembly)),
      terrain(on),
      ground(GroundNormal(on)),
      has_boxes(on.type == TerrainType::kSteps ||
                on.type == TerrainType::kObstacles),
      physics(options.physics),
      on_ground(RobotOnGround(options.physics)),
      on_robot(RobotOnRobot(options.physics)),
      is_direct(options.physics.solver == Solver::kDirect &&
                static_cast<int>(assembly.links.size()) <=
                    options.physics.max_direct_links) {
  OpenOde();
  most_warnings = physics.max_solver_failures * options.duration / physics.step;
  if (on.type == TerrainType::kRough) field.emplace(on.rough);
  world = dWorldCreate();
  // The default one is shared by all worlds and not safe between threads.
  threading = dThreadingAllocateSelfThreadedImplementation();
  dWorldSetStepThreadingImplementation(
      world, dThreadingImplementationGetFunctions(threading), threading);
  // The factor, for absurd robots, is ODE's own.
  const dWorldStepReserveInfo memory = {sizeof(memory), 1.2F, kStepMemory};
  dWorldSetStepMemoryReservationPolicy(world, &memory);
  group = dJointGroupCreate(0);
  dWorldSetGravity(world, 0, 0, -physics.gravity);
  dWorldSetERP(world, physics.world_erp);
  dWorldSetCFM(world, physics.world_cfm);
  dWorldSetDamping(world, physics.damping, physics.damping);
  dWorldSetContactMaxCorrectingVel(world, physics.correcting_speed);
  dWorldSetContactSurfaceLayer(world, physics.surface_layer);
  dWorldSetQuickStepNumIterations(world, physics.solver_iterations);
  std::size_t most_corners = 0;
  for (const Link& link : links) {
    AddBody(link, placement);
    corners.push_back(CornersOf(link));
    most_corners = std::max(most_corners, 8 * link.boxes.size());
    for (const Box& box : link.boxes)
      if (static_cast<std::size_t>(box.module) >= touched.size())
        touched.resize(static_cast<std::size_t>(box.module) + 1);
  }
  // A step asks for no memory. Other grounds grow theirs in the first steps.
  found.reserve(most_corners);
  for (const Hinge& hinge : assembly.hinges)
    AddHinge(hinge, placement, options.servo);
  if (has_boxes) obstacle = dCreateBox(nullptr, 1, 1, 1);
  if (pairs.empty() && !has_boxes) return;
  for (std::size_t i = 0; i < links.size(); ++i) AddGeoms(links[i], bodies[i]);
}

World::Ode::~Ode() {
  for (const auto& of_link : geoms)
    for (const dGeomID geom : of_link) dGeomDestroy(geom);
  if (obstacle != nullptr) dGeomDestroy(obstacle);
  dJointGroupDestroy(group);
  dWorldDestroy(world);
  dThreadingFreeImplementation(threading);
}

void World::Ode::AddBody(const Link& link, const Placement& placement) {
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  const Matrix3d& inertia = link.inertia;
  dMassSetParameters(&mass, link.mass, 0, 0, 0, inertia(0, 0), inertia(1, 1),
                     inertia(2, 2), inertia(0, 1), inertia(0, 2),
                     inertia(1, 2));
  dBodySetMass(body, &mass);
  const Vector3d centre = placement(link.centre);
  dBodySetPosition(body, centre.x(), centre.y(), centre.z());
  if (!placement.axes.isIdentity(0)) {
    dMatrix3 rotation = {};
    FillMatrix(placement.axes, rotation);
    dBodySetRotation(body, rotation);
  }
  bodies.push_back(body);
}

void World::Ode::AddHinge(const Hinge& hinge, const Placement& placement,
                          const ServoOptions& servo) {
  const dJointID joint = dJointCreateHinge(world, nullptr);
  // The child first: its turn against the parent then counts as positive.
  dJointAttach(joint, bodies[static_cast<std::size_t>(hinge.child)],
               bodies[static_cast<std::size_t>(hinge.parent)]);
  const Vector3d anchor = placement(hinge.anchor);
  const Vector3d axis = placement.axes * hinge.axis;
  dJointSetHingeAnchor(joint, anchor.x(), anchor.y(), anchor.z());
  dJointSetHingeAxis(joint, axis.x(), axis.y(), axis.z());
  dJointSetHingeParam(joint, dParamLoStop, -servo.range);
  dJointSetHingeParam(joint, dParamHiStop, servo.range);
  dJointSetHingeParam(joint, dParamFMax, servo.max_torque);
  dJointSetHingeParam(joint, dParamVel, 0);
  hinges.push_back(joint);
}

void World::Ode::AddGeoms(const Link& link, dBodyID body) {
  geoms.emplace_back();
  for (const Box& box : link.boxes) {
    const dGeomID geom =
        dCreateBox(nullptr, box.size.x(), box.size.y(), box.size.z());
    dGeomSetBody(geom, body);
    const Vector3d offset = box.centre - link.centre;
    dGeomSetOffsetPosition(geom, offset.x(), offset.y(), offset.z());
    dMatrix3 rotation = {};
    FillMatrix(box.axes, rotation);
    dGeomSetOffsetRotation(geom, rotation);
    geoms.back().push_back(geom);
  }
}

LinkPose World::Ode::PoseOf(std::size_t link) const {
  return {ToVector(dBodyGetPosition(bodies[link])),
          ToMatrix(dBodyGetRotation(bodies[link]))};
}

bool World::Ode::TakeStep() {
  contacts = 0;
  touched.assign(touched.size(), false);
  const UseSolverOrder use_order(order);
  warnings_in_use = &warnings;
  try {
    Collide();
    if (listener) listener(StepPart::kCollision);
    if (is_direct) {
      dWorldStep(world, physics.step);
    } else {
      dWorldQuickStep(world, physics.step);
    }
  } catch (const OdeFailure&) {
    is_lost = true;
  }
  warnings_in_use = nullptr;
  if (listener) listener(StepPart::kSolver);
  dJointGroupEmpty(group);
  const bool is_sane = is_lost ? Fail(Outcome::kUnstable,
                                      "the solver met numbers beyond its range")
                               : IsSane();
  if (listener) listener(StepPart::kChecks);
  return is_sane;
}

bool World::Ode::Fail(Outcome outcome, std::string reason) {
  failure = {outcome, std::move(reason)};
  return false;
}

bool World::Ode::IsSane() {
  const double deepest = kDeepest + (field ? field->bound() : 0);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double speed = ToVector(dBodyGetLinearVel(bodies[i])).norm();
    const double spin = ToVector(dBodyGetAngularVel(bodies[i])).norm();
    const Vector3d position = ToVector(dBodyGetPosition(bodies[i]));
    const double height = ground.dot(position);
    if (!std::isfinite(speed) || !std::isfinite(spin) || !position.allFinite())
      return Fail(Outcome::kUnstable,
                  fmt::format("link {} has no finite place or speed", i));
    if (speed > physics.max_speed)
      return Fail(Outcome::kUnstable,
                  fmt::format("link {} moves at {:.1f} m/s, more than "
                              "max_speed, {} m/s",
                              i, speed, physics.max_speed));
    if (spin > physics.max_spin)
      return Fail(Outcome::kUnstable,
                  fmt::format("link {} turns at {:.1f} rad/s, more than "
                              "max_spin, {} rad/s",
                              i, spin, physics.max_spin));
    if (height < -(corners[i].radius + deepest))
      return Fail(
          Outcome::kFellThrough,
          fmt::format("link {} is {:.3f} m below the ground", i, -height));
  }
  if (warnings > most_warnings)
    return Fail(Outcome::kSolverFailed,
                fmt::format("the solver failed {} times, more than "
                            "max_solver_failures, {} of the steps",
                            warnings, physics.max_solver_failures));
  return true;
}

World::World(const Assembly& assembly, const Terrain& terrain,
             const SimulationOptions& options)
    : World(assembly, terrain, options,
            StartOf(assembly, terrain, options, {})) {}

World::World(const Assembly& assembly, const Terrain& terrain,
             const SimulationOptions& options, const Placement& placement)
    : ode_(std::make_unique<Ode>(assembly, terrain, options, placement)) {}

World::~World() {
  if (!ode_->is_lost) return;
  // ODE aborts on taking down what an interrupted step left behind. So it is
  // kept, within reach of leak checkers: about 0.1 MB, in a rare event.
  static std::atomic<Ode*> kept = nullptr;
  Ode* const ode = ode_.release();
  ode->next_kept = kept;
  while (!kept.compare_exchange_weak(ode->next_kept, ode)) {
  }
}

void World::SetJointSpeed(int joint, double speed) {
  dJointSetHingeParam(ode_->hinges[static_cast<std::size_t>(joint)], dParamVel,
                      speed);
}

void World::SetMotion(int link, const LinkMotion& motion) {
  const dBodyID body = ode_->bodies[static_cast<std::size_t>(link)];
  dBodySetLinearVel(body, motion.velocity.x(), motion.velocity.y(),
                    motion.velocity.z());
  dBodySetAngularVel(body, motion.spin.x(), motion.spin.y(), motion.spin.z());
}

void World::SetState(int link, const LinkPose& pose, const LinkMotion& motion) {
  const dBodyID body = ode_->bodies[static_cast<std::size_t>(link)];
  dMatrix3 rotation = {};
  FillMatrix(pose.axes, rotation);
  dBodySetPosition(body, pose.position.x(), pose.position.y(),
                   pose.position.z());
  dBodySetRotation(body, rotation);
  SetMotion(link, motion);
}

const World::Failure& World::failure() const {
  return ode_->failure;
}

bool World::Step() {
  assert(!ode_->is_lost);
  return ode_->TakeStep();
}

void World::Listen(std::function<void(StepPart)> listener) {
  ode_->listener = std::move(listener);
}

int World::joints() const {
  return static_cast<int>(ode_->hinges.size());
}

double World::JointAngle(int joint) const {
  return dJointGetHingeAngle(ode_->hinges[static_cast<std::size_t>(joint)]);
}

int World::links() const {
  return static_cast<int>(ode_->links.size());
}

LinkPose World::PoseOf(int link) const {
  return ode_->PoseOf(static_cast<std::size_t>(link));
}

LinkMotion World::MotionOf(int link) const {
  const dBodyID body = ode_->bodies[static_cast<std::size_t>(link)];
  return {ToVector(dBodyGetLinearVel(body)),
          ToVector(dBodyGetAngularVel(body))};
}

Vector3d World::CorePosition() const {
  const LinkPose pose = ode_->PoseOf(0);
  // The core's centre was the origin when the link's was its centre of mass.
  return pose.position - pose.axes * ode_->links[0].centre;
}

Vector3d World::MassCentre() const {
  Vector3d moment = Vector3d::Zero();
  double mass = 0;
  for (std::size_t i = 0; i < ode_->links.size(); ++i) {
    moment += ode_->links[i].mass * ToVector(dBodyGetPosition(ode_->bodies[i]));
    mass += ode_->links[i].mass;
  }
  return moment / mass;
}

int World::contacts() const {
  return ode_->contacts;
}

const std::vector<bool>& World::touched() const {
  return ode_->touched;
}

int World::solver_warnings() const {
  return ode_->warnings;
}

std::uint64_t World::Hash() const {
  Fnv hash;
  for (const dBodyID body : ode_->bodies) {
    const dReal* quaternion = dBodyGetQuaternion(body);
    for (int i = 0; i < 3; ++i) hash.Add(dBodyGetPosition(body)[i]);
    for (int i = 0; i < 4; ++i) hash.Add(quaternion[i]);
    for (int i = 0; i < 3; ++i) hash.Add(dBodyGetLinearVel(body)[i]);
    for (int i = 0; i < 3; ++i) hash.Add(dBodyGetAngularVel(body)[i]);
  }
  return hash.value();
}

}  // namespace plsc
