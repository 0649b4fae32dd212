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
//
// A step of the direct solver grows with the cube of a robot's links, so robots
// of more than max_direct_links get the iterative one.

#include "sim/ode/ode_engine.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstdarg>
#include <cstddef>
#include <memory>

#include "sim/fnv.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Thrown where ODE would abort the process: its assertions are active, and a
/// state that overflows within a step fails one.
struct OdeFailure {};

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

/// A world that is never taken down, within reach of leak checkers: about
/// 0.1 MB, in a rare event.
struct Kept {
  dWorldID world;
  dJointGroupID group;
  Kept* next;
};

void Keep(dWorldID world, dJointGroupID group) {
  static std::atomic<Kept*> all = nullptr;
  auto* const kept = new Kept{world, group, all};
  while (!all.compare_exchange_weak(kept->next, kept)) {
  }
}

}  // namespace

OdeEngine::OdeEngine(const Scene& scene)
    : Engine(scene.assembly),
      links(scene.assembly.links),
      pairs(CollidingPairs(scene.assembly)),
      terrain(scene.terrain),
      ground(GroundNormal(terrain)),
      has_boxes(terrain.type == TerrainType::kSteps ||
                terrain.type == TerrainType::kObstacles),
      physics(scene.options.physics),
      on_ground(RobotOnGround(physics)),
      on_robot(RobotOnRobot(physics)),
      is_direct(physics.solver == Solver::kDirect &&
                static_cast<int>(links.size()) <= physics.max_direct_links),
      check(scene) {
  const Placement& placement = scene.placement;
  OpenOde();
  if (terrain.type == TerrainType::kRough) field.emplace(terrain.rough);
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
  }
  // A step asks for no memory. Other grounds grow theirs in the first steps.
  found.reserve(most_corners);
  loads.reserve(scene.assembly.hinges.size());
  for (const Hinge& hinge : scene.assembly.hinges)
    AddHinge(hinge, placement, scene.options.servo);
  if (has_boxes) obstacle = dCreateBox(nullptr, 1, 1, 1);
  if (pairs.empty() && !has_boxes) return;
  for (std::size_t i = 0; i < links.size(); ++i) AddGeoms(links[i], bodies[i]);
}

OdeEngine::~OdeEngine() {
  if (obstacle != nullptr) dGeomDestroy(obstacle);  // on no body
  // ODE aborts on taking down what an interrupted step left behind.
  if (is_lost) {
    Keep(world, group);
    return;
  }
  for (const auto& of_link : geoms)
    for (const dGeomID geom : of_link) dGeomDestroy(geom);
  dJointGroupDestroy(group);
  dWorldDestroy(world);
  dThreadingFreeImplementation(threading);
}

void OdeEngine::AddBody(const Link& link, const Placement& placement) {
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

void OdeEngine::AddHinge(const Hinge& hinge, const Placement& placement,
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
  // ODE keeps a pointer; as many are reserved as there are hinges.
  dJointSetFeedback(joint, &loads.emplace_back().feedback);
  hinges.push_back(joint);
}

void OdeEngine::AddGeoms(const Link& link, dBodyID body) {
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

bool OdeEngine::Step() {
  assert(!is_lost);
  contacts = 0;
  touched.assign(touched.size(), false);
  const UseSolverOrder use_order(order);
  warnings_in_use = &warnings;
  try {
    Collide();
    if (listener) listener(StepPart::kCollision);
    NoteLoads();
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
  failure = {};
  if (is_lost) {
    failure = {Outcome::kUnstable, "the solver met numbers beyond its range"};
  } else {
    IsSane();
  }
  if (listener) listener(StepPart::kChecks);
  return failure.outcome == Outcome::kCompleted;
}

/// Sets failure if not.
bool OdeEngine::IsSane() {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const int link = static_cast<int>(i);
    failure =
        check.Look(link, ToVector(dBodyGetPosition(bodies[i])), MotionOf(link));
    if (failure.outcome != Outcome::kCompleted) return false;
  }
  failure = check.LookAtSolver(warnings);
  return failure.outcome == Outcome::kCompleted;
}

void OdeEngine::SetJointSpeed(int joint, double speed) {
  dJointSetHingeParam(hinges[static_cast<std::size_t>(joint)], dParamVel,
                      speed);
}

void OdeEngine::SetMotion(int link, const LinkMotion& motion) {
  const dBodyID body = bodies[static_cast<std::size_t>(link)];
  dBodySetLinearVel(body, motion.velocity.x(), motion.velocity.y(),
                    motion.velocity.z());
  dBodySetAngularVel(body, motion.spin.x(), motion.spin.y(), motion.spin.z());
}

void OdeEngine::SetState(int link, const LinkPose& pose,
                         const LinkMotion& motion) {
  const dBodyID body = bodies[static_cast<std::size_t>(link)];
  dMatrix3 rotation = {};
  FillMatrix(pose.axes, rotation);
  dBodySetPosition(body, pose.position.x(), pose.position.y(),
                   pose.position.z());
  dBodySetRotation(body, rotation);
  SetMotion(link, motion);
}

double OdeEngine::JointAngle(int joint) const {
  return dJointGetHingeAngle(hinges[static_cast<std::size_t>(joint)]);
}

void OdeEngine::TellJointSpeeds(std::vector<double>& speeds) const {
  for (std::size_t i = 0; i < hinges.size(); ++i)
    speeds[i] = dJointGetHingeAngleRate(hinges[i]);
}

void OdeEngine::NoteLoads() {
  for (std::size_t i = 0; i < hinges.size(); ++i) {
    dVector3 place = {};
    dJointGetHingeAxis(hinges[i], place);
    loads[i].axis = ToVector(place);
    dJointGetHingeAnchor(hinges[i], place);
    const dBodyID child = dJointGetBody(hinges[i], 0);
    loads[i].arm = ToVector(place) - ToVector(dBodyGetPosition(child));
  }
}

// What a hinge does to its child is a force in its anchor and a torque; of the
// torque what lies along its axis is the servo's, all else is what holds it.
void OdeEngine::TellJointTorques(std::vector<double>& torques) const {
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const HingeLoad& load = loads[i];
    const Vector3d torque =
        ToVector(load.feedback.t1) - load.arm.cross(ToVector(load.feedback.f1));
    torques[i] = torque.dot(load.axis);
  }
}

LinkPose OdeEngine::PoseOf(int link) const {
  const dBodyID body = bodies[static_cast<std::size_t>(link)];
  return {ToVector(dBodyGetPosition(body)), ToMatrix(dBodyGetRotation(body))};
}

LinkMotion OdeEngine::MotionOf(int link) const {
  const dBodyID body = bodies[static_cast<std::size_t>(link)];
  return {ToVector(dBodyGetLinearVel(body)),
          ToVector(dBodyGetAngularVel(body))};
}

std::uint64_t OdeEngine::Hash() const {
  Fnv hash;
  for (const dBodyID body : bodies) {
    const dReal* quaternion = dBodyGetQuaternion(body);
    for (int i = 0; i < 3; ++i) hash.Add(dBodyGetPosition(body)[i]);
    for (int i = 0; i < 4; ++i) hash.Add(quaternion[i]);
    for (int i = 0; i < 3; ++i) hash.Add(dBodyGetLinearVel(body)[i]);
    for (int i = 0; i < 3; ++i) hash.Add(dBodyGetAngularVel(body)[i]);
  }
  return hash.value();
}

std::unique_ptr<Engine> MakeOdeEngine(const Scene& scene) {
  return std::make_unique<OdeEngine>(scene);
}

}  // namespace plsc
