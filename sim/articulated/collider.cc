// The ground first, link by link, then pairs of links, in the order of the
// assembly: the solver's sums run in this order. Bounds keep it cheap. Of a
// link's points on the ground at most four are handed on (Spanning), and
// modules count as touched before that choice, as in sim/ode.
//
// Pairs of links are looked at only when they may have met. Two points of
// links a and b, seen from the link that carries both, approach by at most
// reach = sum over the joints between of the distance from that joint to the
// farthest point beyond it, per rad that any of them turns. So a gap found once
// is a budget: until the robot's joints have turned by gap / reach, nothing can
// touch, and most steps look at no pair. The bound is exact; a pair that is
// near is looked at every step.
//
// Two boxes meet by sim/articulated/box_contact, boxes that stand on the ground
// included.

#include "sim/articulated/collider.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/articulated/box_contact.h"
#include "sim/overlap.h"
#include "sim/placement.h"

namespace plsc::articulated {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kFar = std::numeric_limits<double>::infinity();

// Of a normal's z: within 45 degrees of the vertical it holds up.
constexpr double kUpright = 0.7071;

// Boxes on the ground that a robot's box may be at, with memory from the start.
constexpr std::size_t kReservedBoxes = 16;

OrientedBox Put(const BoxModel& box, const LinkState& link,
                const Vector3d& origin) {
  OrientedBox put;
  const Vector3d centre = origin + link.place + link.axes * box.centre;
  for (int i = 0; i < 3; ++i) {
    put.centre[i] = centre[i];
    put.half[i] = box.half[i];
    for (int j = 0; j < 3; ++j) put.axes[i][j] = link.axes(j, i);
  }
  return put;
}

OrientedBox Put(const StaticBox& box) {
  OrientedBox put = {};
  for (int i = 0; i < 3; ++i) {
    put.centre[i] = box.centre[i];
    put.half[i] = box.size[i] / 2;
    put.axes[i][i] = 1;
  }
  return put;
}

Vector3d ToVector(const double (&numbers)[3]) {
  return {numbers[0], numbers[1], numbers[2]};
}

/// m per rad: how far turning joints below `common` can move points of `link`,
/// each joint by as much.
double ReachOf(const Model& model, int link, int common) {
  const auto& links = model.links();
  double sum = 0;
  double farthest = links[static_cast<std::size_t>(link)].radius;
  for (int k = link; k != common;) {
    const LinkModel& own = links[static_cast<std::size_t>(k)];
    farthest += own.arm.norm();
    sum += farthest;
    farthest += own.anchor.norm();
    k = own.parent;
  }
  return sum;
}

/// The link nearest to both from which a path leads down to each.
int CommonOf(const Model& model, int a, int b) {
  const auto& links = model.links();
  while (a != b) {
    int& later = a > b ? a : b;  // parents precede children
    later = links[static_cast<std::size_t>(later)].parent;
  }
  return a;
}

}  // namespace

Matrix3d GroundAxes(const Terrain& terrain) {
  return AlignedAxes(terrain);
}

Collider::Collider(const Scene& scene, const Model& model)
    : model_(model),
      terrain_(scene.terrain),
      axes_(GroundAxes(scene.terrain)),
      has_boxes_(terrain_.type == TerrainType::kSteps ||
                 terrain_.type == TerrainType::kObstacles),
      highest_(terrain_.type == TerrainType::kSteps
                   ? terrain_.steps.count * terrain_.steps.height
                   : terrain_.obstacles.height) {
  if (terrain_.type == TerrainType::kRough) field_.emplace(terrain_.rough);
  std::size_t most = 0;
  for (const Link& link : scene.assembly.links) {
    corners_.push_back(CornersOf(link));
    most = std::max(most, 27 * link.boxes.size());
  }
  for (auto* of_link : {&found_, &upright_, &leaning_}) of_link->reserve(most);
  near_.reserve(kReservedBoxes);
  contacts_.reserve(ReservedContacts(scene.assembly.links.size()));
  for (const LinkPair& pair : CollidingPairs(scene.assembly)) {
    const int common = CommonOf(model, pair.a, pair.b);
    pairs_.push_back(
        {pair.a, pair.b,
         ReachOf(model, pair.a, common) + ReachOf(model, pair.b, common)});
  }
}

void Collider::Forget() {
  next_due_ = 0;
  for (Pair& pair : pairs_) pair.due = 0;
}

const std::vector<Contact>& Collider::Find(const State& state, double turned,
                                           std::vector<bool>& touched) {
  contacts_.clear();
  for (int link = 0; link < model_.size(); ++link)
    FindGround(state, link, touched);
  if (has_boxes_)
    for (int link = 0; link < model_.size(); ++link)
      FindStatic(state, link, touched);
  FindPairs(state, turned, touched);
  return contacts_;
}

/// As ODE chooses them, in the world's axes: the pyramid of friction stands
/// where it stands in sim/ode. On the plane itself they are its own axes.
std::array<Vector3d, 3> Collider::Directions(const Vector3d& normal) const {
  const Vector3d n = axes_ * normal;
  Vector3d p, q;
  if (std::abs(n.z()) > kUpright) {
    const double a = n.y() * n.y() + n.z() * n.z();
    const double k = 1 / std::sqrt(a);
    p = {0, -n.z() * k, n.y() * k};
    q = {a * k, -n.x() * p.z(), n.x() * p.y()};
  } else {
    const double a = n.x() * n.x() + n.y() * n.y();
    const double k = 1 / std::sqrt(a);
    p = {-n.y() * k, n.x() * k, 0};
    q = {-n.z() * p.y(), n.z() * p.x(), a * k};
  }
  return {normal, axes_.transpose() * p, axes_.transpose() * q};
}

void Collider::Push(int link, const FewContacts& points, std::uint64_t kind) {
  for (const GroundContact& point : points) {
    Contact contact;
    contact.link = link;
    contact.point = point.position;
    contact.is_on_plane = kind == 0 && !field_;
    if (contact.is_on_plane) {
      contact.directions = {Vector3d::UnitZ(), Vector3d::UnitX(),
                            Vector3d::UnitY()};
    } else {
      contact.directions = Directions(point.normal);
    }
    contact.depth = point.depth;
    contact.key = (kind << 56) | (static_cast<std::uint64_t>(link) << 40) |
                  static_cast<std::uint64_t>(point.key);
    contacts_.push_back(contact);
  }
}

void Collider::FindGround(const State& state, int link,
                          std::vector<bool>& touched) {
  const auto k = static_cast<std::size_t>(link);
  const LinkState& own = state.links[k];
  if (!field_ && state.base.z() + own.place.z() > corners_[k].radius) return;
  const LinkPose pose = {state.base + own.place, own.axes};
  found_.clear();
  if (field_) {
    AppendRoughContacts(corners_[k], pose, *field_, found_);
  } else {
    AppendGroundContacts(corners_[k], pose, Vector3d::UnitZ(), found_);
  }
  if (found_.empty()) return;
  for (const GroundContact& contact : found_)
    touched[static_cast<std::size_t>(contact.module)] = true;
  const std::size_t first = contacts_.size();
  Push(link, Spanning(found_, Vector3d::UnitZ()), 0);
  for (std::size_t i = first; i < contacts_.size(); ++i)
    contacts_[i].point -= state.base;
}

void Collider::FindStatic(const State& state, int link,
                          std::vector<bool>& touched) {
  const auto k = static_cast<std::size_t>(link);
  const LinkState& own = state.links[k];
  if (state.base.z() + own.place.z() - corners_[k].radius > highest_) return;
  upright_.clear();
  leaning_.clear();
  const auto& boxes = model_.links()[k].boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vector3d centre = state.base + own.place + own.axes * boxes[i].centre;
    const Vector3d reach = own.axes.cwiseAbs() * boxes[i].half;
    near_.clear();
    AppendStaticBoxes(terrain_, {centre - reach, centre + reach}, near_);
    std::uint64_t which = 0;
    for (const StaticBox& other : near_) {
      std::array<BoxContact, kMostBoxContacts> points;
      const int count =
          CollideBoxes(Put(boxes[i], own, state.base), Put(other), points);
      if (count > 0) touched[static_cast<std::size_t>(boxes[i].module)] = true;
      for (int point = 0; point < count; ++point) {
        const BoxContact& at = points[static_cast<std::size_t>(point)];
        const Vector3d normal = ToVector(at.normal);
        auto& kind = normal.z() > kUpright ? upright_ : leaning_;
        kind.push_back(
            {boxes[i].module, at.depth, ToVector(at.position), normal,
             static_cast<int>((i * 8 + which) * kBoxContactKeys) + at.key});
      }
      which = (which + 1) % 8;
    }
  }
  // Apart, as four points that hold a link up would crowd out those that keep
  // it from walking through a wall.
  const std::size_t first = contacts_.size();
  Push(link, Spanning(upright_, Vector3d::UnitZ()), 1);
  if (!leaning_.empty())
    Push(link, Spanning(leaning_, leaning_.front().normal), 2);
  for (std::size_t i = first; i < contacts_.size(); ++i)
    contacts_[i].point -= state.base;
}

void Collider::FindPairs(const State& state, double turned,
                         std::vector<bool>& touched) {
  turned_ += turned;
  if (turned_ < next_due_) return;
  next_due_ = kFar;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    Pair& pair = pairs_[i];
    if (turned_ >= pair.due) {
      const double gap = FindPair(state, i, touched);
      pair.due = gap > 0 ? turned_ + gap / pair.reach : turned_;
    }
    next_due_ = std::min(next_due_, pair.due);
  }
}

/// m, that the two links are apart at least; at most 0 if they touch.
double Collider::FindPair(const State& state, std::size_t pair,
                          std::vector<bool>& touched) {
  const Pair& own = pairs_[pair];
  const auto ia = static_cast<std::size_t>(own.a);
  const auto ib = static_cast<std::size_t>(own.b);
  const LinkModel& a = model_.links()[ia];
  const LinkModel& b = model_.links()[ib];
  const LinkState& at_a = state.links[ia];
  const LinkState& at_b = state.links[ib];
  const double apart = (at_a.place - at_b.place).norm() - a.radius - b.radius;
  if (apart > 0) return apart;
  double least = kFar;
  for (std::size_t i = 0; i < a.boxes.size(); ++i) {
    const Vector3d centre = at_a.place + at_a.axes * a.boxes[i].centre;
    for (std::size_t j = 0; j < b.boxes.size(); ++j) {
      const Vector3d other = at_b.place + at_b.axes * b.boxes[j].centre;
      double gap =
          (centre - other).norm() - a.boxes[i].radius - b.boxes[j].radius;
      if (gap <= 0) {
        std::array<BoxContact, kMostBoxContacts> points;
        const int count =
            CollideBoxes(Put(a.boxes[i], at_a, Vector3d::Zero()),
                         Put(b.boxes[j], at_b, Vector3d::Zero()), points, gap);
        const std::uint64_t key = (std::uint64_t{3} << 56) |
                                  (std::uint64_t{pair} << 32) |
                                  ((i * b.boxes.size() + j) * kBoxContactKeys);
        for (int point = 0; point < count; ++point) {
          const BoxContact& touch = points[static_cast<std::size_t>(point)];
          Contact contact;
          contact.link = own.a;
          contact.other = own.b;
          contact.point = ToVector(touch.position);
          contact.directions = Directions(ToVector(touch.normal));
          contact.depth = touch.depth;
          contact.key = key + static_cast<std::uint64_t>(touch.key);
          contacts_.push_back(contact);
        }
        if (count > 0) {
          touched[static_cast<std::size_t>(a.boxes[i].module)] = true;
          touched[static_cast<std::size_t>(b.boxes[j].module)] = true;
        }
      }
      least = std::min(least, gap);
    }
  }
  return least;
}

}  // namespace plsc::articulated
