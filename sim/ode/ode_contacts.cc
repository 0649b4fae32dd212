// What touches what, and with how many points: each contact is three rows of
// the problem that a step solves, so this decides what a step costs. Three
// bounds keep it down. Spheres about links and boxes sort out what is far
// apart. Of all corners of a link on the ground at most four are handed on, the
// ones that span its support (sim/ground). Of two boxes ODE gives four.
//
// A module counts as touched by any of its contacts, before the choice of the
// four: what sensors feel must not depend on which corners hold the link best.
// Contacts live for one step, and are made link by link and pair by pair in a
// fixed order, on which the solver's rounding depends.

#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "sim/ode/ode_engine.h"

namespace plsc {
namespace {

using Eigen::Vector3d;

// Of two boxes; ODE gives up to 8, and 4 hold as well.
constexpr int kMaxBoxContacts = 4;

// Of a normal's z: within 45 degrees of the vertical it holds up.
constexpr double kUpright = 0.7071;

}  // namespace

void OdeEngine::AddContact(const dContactGeom& geometry, const ContactLaw& law,
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

void OdeEngine::Push(std::size_t link, const FewContacts& points) {
  for (const GroundContact& contact : points) {
    dContactGeom geometry = {};
    for (int i = 0; i < 3; ++i) {
      geometry.pos[i] = contact.position[i];
      geometry.normal[i] = contact.normal[i];
    }
    geometry.depth = contact.depth;
    AddContact(geometry, on_ground, bodies[link], nullptr);
  }
}

void OdeEngine::CollideGround(std::size_t link) {
  found.clear();
  AppendGroundContacts(corners[link], PoseOf(static_cast<int>(link)), ground,
                       found);
  for (const GroundContact& contact : found)
    touched[static_cast<std::size_t>(contact.module)] = true;
  Push(link, Spanning(found, ground));
}

void OdeEngine::CollideRough(std::size_t link) {
  found.clear();
  AppendRoughContacts(corners[link], PoseOf(static_cast<int>(link)), *field,
                      found);
  for (const GroundContact& contact : found)
    touched[static_cast<std::size_t>(contact.module)] = true;
  Push(link, Spanning(found, ground));
}

/// The points where one box of the robot meets one of the ground, sorted by
/// whether they hold it up or aside.
void OdeEngine::CollideObstacle(std::size_t link, std::size_t box,
                                const StaticBox& other) {
  dGeomBoxSetLengths(obstacle, other.size.x(), other.size.y(), other.size.z());
  dGeomSetPosition(obstacle, other.centre.x(), other.centre.y(),
                   other.centre.z());
  std::array<dContactGeom, kMaxBoxContacts> points = {};
  const int count = dCollide(geoms[link][box], obstacle, kMaxBoxContacts,
                             points.data(), sizeof(dContactGeom));
  const int module = links[link].boxes[box].module;
  if (count > 0) touched[static_cast<std::size_t>(module)] = true;
  for (int i = 0; i < count; ++i) {
    const dContactGeom& point = points[static_cast<std::size_t>(i)];
    const Vector3d normal = ToVector(point.normal);
    auto& kind = normal.z() > kUpright ? upright : leaning;
    kind.push_back({module, point.depth, ToVector(point.pos), normal});
  }
}

void OdeEngine::CollideObstacles(std::size_t link) {
  const double highest = terrain.type == TerrainType::kSteps
                             ? terrain.steps.count * terrain.steps.height
                             : terrain.obstacles.height;
  if (dBodyGetPosition(bodies[link])[2] - corners[link].radius > highest)
    return;
  upright.clear();
  leaning.clear();
  for (std::size_t i = 0; i < geoms[link].size(); ++i) {
    dReal extent[6];  // low and high x, y, z
    dGeomGetAABB(geoms[link][i], extent);
    boxes_near.clear();
    AppendStaticBoxes(
        terrain,
        Eigen::AlignedBox3d(Vector3d(extent[0], extent[2], extent[4]),
                            Vector3d(extent[1], extent[3], extent[5])),
        boxes_near);
    for (const StaticBox& other : boxes_near) CollideObstacle(link, i, other);
  }
  // Apart, as four points that hold a link up would crowd out those that keep
  // it from walking through a wall.
  Push(link, Spanning(upright, Vector3d::UnitZ()));
  if (!leaning.empty()) Push(link, Spanning(leaning, leaning.front().normal));
}

void OdeEngine::Collide() {
  if (field) {
    for (std::size_t i = 0; i < links.size(); ++i) CollideRough(i);
  } else {
    for (std::size_t i = 0; i < links.size(); ++i) CollideGround(i);
  }
  if (has_boxes)
    for (std::size_t i = 0; i < links.size(); ++i) CollideObstacles(i);
  for (const LinkPair& pair : pairs)
    CollideLinks(static_cast<std::size_t>(pair.a),
                 static_cast<std::size_t>(pair.b));
}

void OdeEngine::CollideLinks(std::size_t a, std::size_t b) {
  const Vector3d apart = ToVector(dBodyGetPosition(bodies[a])) -
                         ToVector(dBodyGetPosition(bodies[b]));
  const double reach = corners[a].radius + corners[b].radius;
  if (apart.squaredNorm() > reach * reach) return;
  for (std::size_t i = 0; i < geoms[a].size(); ++i)
    for (std::size_t j = 0; j < geoms[b].size(); ++j) CollideBoxes(a, b, i, j);
}

void OdeEngine::CollideBoxes(std::size_t a, std::size_t b, std::size_t box_a,
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

}  // namespace plsc
