#include "sim/world.h"

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <cassert>
#include <cstdarg>
#include <cstddef>
#include <mutex>

#include "sim/contact_law.h"
#include "sim/overlap.h"
#include "sim/solver_order.h"
#include "sim/state_hash.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Thrown where ODE would abort the process: its assertions are active, and a
/// state that overflows within a step fails one.
struct OdeFailure {};

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
  static std::once_flag once;
  std::call_once(once, [] {
    dInitODE2(0);
    dSetMessageHandler(CountWarning);
    dSetErrorHandler(Fail);
    dSetDebugHandler(Fail);
  });
}

Vector3d ToVector(const dReal* numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// ODE's rotations are 3 rows of 4.
Matrix3d ToMatrix(const dReal* numbers) {
  return Eigen::Map<const Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>>(numbers)
      .leftCols<3>();
}

// The worlds of the authors' program (plane.world, tilted5.world).
constexpr double kMaxCorrectingSpeed = 100;  // m/s
constexpr double kSurfaceLayer = 1e-8;       // m, depth left uncorrected

// Of two boxes; ODE gives up to 8, and 4 hold as well.
constexpr int kMaxBoxContacts = 4;

}  // namespace

struct World::Ode {
  dWorldID world = nullptr;
  dThreadingImplementationID threading = nullptr;
  dJointGroupID group = nullptr;
  std::vector<dBodyID> bodies;
  std::vector<dJointID> hinges;
  std::vector<std::vector<dGeomID>> geoms;  ///< by link; empty if no pairs

  std::vector<Link> links;  ///< in the rest pose
  std::vector<LinkCorners> corners;
  std::vector<LinkPair> pairs;
  std::vector<bool> touched;
  std::vector<GroundContact> found;  ///< kept for its memory only
  Vector3d ground;                   ///< normal
  PhysicsOptions physics;
  ContactLaw on_ground, on_robot;
  SolverOrder order;
  int contacts = 0;
  int warnings = 0;
  bool is_direct = true;
  bool is_lost = false;  ///< interrupted within a step
  Ode* next_kept = nullptr;

  Ode(const Assembly& assembly, const Terrain& terrain,
      const SimulationOptions& options);
  ~Ode();
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;

  void AddBody(const Link& link, double start_height);
  void AddHinge(const Hinge& hinge, double start_height,
                const ServoOptions& servo);
  void AddGeoms(const Link& link, dBodyID body);

  LinkPose PoseOf(std::size_t link) const;
  void CollideGround(std::size_t link);
  void CollideLinks(std::size_t a, std::size_t b);
  void CollideBoxes(std::size_t a, std::size_t b, std::size_t box_a,
                    std::size_t box_b);
  void AddContact(const dContactGeom& geometry, const ContactLaw& law,
                  dBodyID first, dBodyID second);
  bool TakeStep();
  bool IsSane() const;
};

World::Ode::Ode(const Assembly& assembly, const Terrain& terrain,
                const SimulationOptions& options)
    : links(assembly.links),
      pairs(CollidingPairs(assembly)),
      ground(GroundNormal(terrain)),
      physics(options.physics),
      on_ground(RobotOnGround(options.physics)),
      on_robot(RobotOnRobot(options.physics)),
      is_direct(options.physics.solver == Solver::kDirect &&
                static_cast<int>(assembly.links.size()) <=
                    options.physics.max_direct_links) {
  OpenOde();
  world = dWorldCreate();
  // The default one is shared by all worlds and not safe between threads.
  threading = dThreadingAllocateSelfThreadedImplementation();
  dWorldSetStepThreadingImplementation(
      world, dThreadingImplementationGetFunctions(threading), threading);
  group = dJointGroupCreate(0);
  dWorldSetGravity(world, 0, 0, -physics.gravity);
  dWorldSetERP(world, physics.world_erp);
  dWorldSetCFM(world, physics.world_cfm);
  dWorldSetDamping(world, physics.damping, physics.damping);
  dWorldSetContactMaxCorrectingVel(world, kMaxCorrectingSpeed);
  dWorldSetContactSurfaceLayer(world, kSurfaceLayer);
  dWorldSetQuickStepNumIterations(world, physics.solver_iterations);
  for (const Link& link : links) {
    AddBody(link, options.start_height);
    corners.push_back(CornersOf(link));
    for (const Box& box : link.boxes)
      if (static_cast<std::size_t>(box.module) >= touched.size())
        touched.resize(static_cast<std::size_t>(box.module) + 1);
  }
  for (const Hinge& hinge : assembly.hinges)
    AddHinge(hinge, options.start_height, options.servo);
  if (pairs.empty()) return;
  for (std::size_t i = 0; i < links.size(); ++i) AddGeoms(links[i], bodies[i]);
}

World::Ode::~Ode() {
  for (const auto& of_link : geoms)
    for (const dGeomID geom : of_link) dGeomDestroy(geom);
  dJointGroupDestroy(group);
  dWorldDestroy(world);
  dThreadingFreeImplementation(threading);
}

void World::Ode::AddBody(const Link& link, double start_height) {
  const dBodyID body = dBodyCreate(world);
  dMass mass;
  const Matrix3d& inertia = link.inertia;
  dMassSetParameters(&mass, link.mass, 0, 0, 0, inertia(0, 0), inertia(1, 1),
                     inertia(2, 2), inertia(0, 1), inertia(0, 2),
                     inertia(1, 2));
  dBodySetMass(body, &mass);
  dBodySetPosition(body, link.centre.x(), link.centre.y(),
                   link.centre.z() + start_height);
  bodies.push_back(body);
}

void World::Ode::AddHinge(const Hinge& hinge, double start_height,
                          const ServoOptions& servo) {
  const dJointID joint = dJointCreateHinge(world, nullptr);
  // The child first: its turn against the parent then counts as positive.
  dJointAttach(joint, bodies[static_cast<std::size_t>(hinge.child)],
               bodies[static_cast<std::size_t>(hinge.parent)]);
  dJointSetHingeAnchor(joint, hinge.anchor.x(), hinge.anchor.y(),
                       hinge.anchor.z() + start_height);
  dJointSetHingeAxis(joint, hinge.axis.x(), hinge.axis.y(), hinge.axis.z());
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
    Eigen::Map<Eigen::Matrix<dReal, 3, 4, Eigen::RowMajor>>(rotation)
        .leftCols<3>() = box.axes;
    dGeomSetOffsetRotation(geom, rotation);
    geoms.back().push_back(geom);
  }
}

LinkPose World::Ode::PoseOf(std::size_t link) const {
  return {ToVector(dBodyGetPosition(bodies[link])),
          ToMatrix(dBodyGetRotation(bodies[link]))};
}

void World::Ode::AddContact(const dContactGeom& geometry, const ContactLaw& law,
                            dBodyID first, dBodyID second) {
  dContact contact = {};  // ODE reads fields that the mode does not name
  // Approx1 makes mu a coefficient; without it, it would be a force in N.
  contact.surface.mode = dContactApprox1 | dContactSlip1 | dContactSlip2 |
                         dContactSoftERP | dContactSoftCFM;
  contact.surface.mu = physics.friction;
  contact.surface.slip1 = physics.slip;
  contact.surface.slip2 = physics.slip;
  contact.surface.soft_erp = law.erp;
  contact.surface.soft_cfm = law.cfm;
  contact.geom = geometry;
  dJointAttach(dJointCreateContact(world, group, &contact), first, second);
  ++contacts;
}

void World::Ode::CollideGround(std::size_t link) {
  found.clear();
  AppendGroundContacts(corners[link], PoseOf(link), ground, found);
  for (const GroundContact& contact : found)
    touched[static_cast<std::size_t>(contact.module)] = true;
  for (const GroundContact& contact : Spanning(found, ground)) {
    dContactGeom geometry = {};
    for (int i = 0; i < 3; ++i) {
      geometry.pos[i] = contact.position[i];
      geometry.normal[i] = ground[i];
    }
    geometry.depth = contact.depth;
    AddContact(geometry, on_ground, bodies[link], nullptr);
  }
}

void World::Ode::CollideLinks(std::size_t a, std::size_t b) {
  const Vector3d apart = ToVector(dBodyGetPosition(bodies[a])) -
                         ToVector(dBodyGetPosition(bodies[b]));
  const double reach = corners[a].radius + corners[b].radius;
  if (apart.squaredNorm() > reach * reach) return;
  for (std::size_t i = 0; i < geoms[a].size(); ++i)
    for (std::size_t j = 0; j < geoms[b].size(); ++j) CollideBoxes(a, b, i, j);
}

void World::Ode::CollideBoxes(std::size_t a, std::size_t b, std::size_t box_a,
                              std::size_t box_b) {
  const Box& first = links[a].boxes[box_a];
  const Box& second = links[b].boxes[box_b];
  const dGeomID geom_a = geoms[a][box_a];
  const dGeomID geom_b = geoms[b][box_b];
  const double reach = (first.size.norm() + second.size.norm()) / 2;
  const Vector3d apart =
      ToVector(dGeomGetPosition(geom_a)) - ToVector(dGeomGetPosition(geom_b));
  if (apart.squaredNorm() > reach * reach) return;
  std::array<dContactGeom, kMaxBoxContacts> points = {};
  const int count = dCollide(geom_a, geom_b, kMaxBoxContacts, points.data(),
                             sizeof(dContactGeom));
  for (int i = 0; i < count; ++i)
    AddContact(points[static_cast<std::size_t>(i)], on_robot, bodies[a],
               bodies[b]);
  if (count == 0) return;
  touched[static_cast<std::size_t>(first.module)] = true;
  touched[static_cast<std::size_t>(second.module)] = true;
}

bool World::Ode::TakeStep() {
  contacts = 0;
  touched.assign(touched.size(), false);
  const UseSolverOrder use_order(order);
  warnings_in_use = &warnings;
  try {
    for (std::size_t i = 0; i < links.size(); ++i) CollideGround(i);
    for (const LinkPair& pair : pairs)
      CollideLinks(static_cast<std::size_t>(pair.a),
                   static_cast<std::size_t>(pair.b));
    if (is_direct) {
      dWorldStep(world, physics.step);
    } else {
      dWorldQuickStep(world, physics.step);
    }
  } catch (const OdeFailure&) {
    is_lost = true;
  }
  warnings_in_use = nullptr;
  dJointGroupEmpty(group);
  return !is_lost && IsSane();
}

bool World::Ode::IsSane() const {
  for (const dBodyID body : bodies) {
    const double speed = ToVector(dBodyGetLinearVel(body)).norm();
    const double spin = ToVector(dBodyGetAngularVel(body)).norm();
    // Written so that a NaN, which compares false, is not sane.
    if (!(speed <= kMaxSpeed && spin <= kMaxSpin)) return false;
    if (!ToVector(dBodyGetPosition(body)).allFinite()) return false;
  }
  return true;
}

World::World(const Assembly& assembly, const Terrain& terrain,
             const SimulationOptions& options)
    : ode_(std::make_unique<Ode>(assembly, terrain, options)) {}

World::~World() {
  if (!ode_->is_lost) return;
  // ODE aborts on taking down what an interrupted step left behind. So it is
  // kept, within reach of leak checkers: about 0.1 MB, in a rare event.
  static std::mutex mutex;
  static Ode* kept = nullptr;
  const std::lock_guard lock(mutex);
  ode_->next_kept = kept;
  kept = ode_.release();
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

bool World::Step() {
  assert(!ode_->is_lost);
  return ode_->TakeStep();
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
  StateHash hash;
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
