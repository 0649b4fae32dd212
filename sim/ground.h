#pragma once

// Where a rigid link of boxes meets the ground. Box corners against a plane,
// and of all corners of a link only a few that hold it as firmly: rows of the
// contact problem are what a step costs (4 contacts for every box cost 4.5
// times as much when many bottoms lie in one plane). Geometry only.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

#include "sim/assembly.h"
#include "sim/height_field.h"
#include "sim/terrain.h"

namespace plsc {

/// Contacts of one link that the solver gets. Four span the support of any
/// link but for slivers of it.
inline constexpr int kMaxGroundContacts = 4;

/// Unit normal of the plane of the ground, which passes through the origin;
/// of grounds that are no plane, the vertical.
Eigen::Vector3d GroundNormal(const Terrain& terrain);

/// The corners of a box, about its link's centre of mass.
struct BoxCorners {
  int module = 0;  ///< index into Body::modules
  Eigen::Matrix<double, 3, 8> points;
  /// Points that rough ground is held against: the corners, and the middles
  /// of edges and faces of sides longer than kFineSide.
  Eigen::Matrix3Xd fine;
  double radius = 0;       ///< m, from the centre to a corner
  Eigen::Vector3d centre;  ///< m
  Eigen::Vector3d half;    ///< m, half the extent along the link's axes
};

/// m. Sides of a core, a brick, a frame, a plate and a sensor can be longer;
/// a core's points are 44.5 mm apart, all others at most 20.5 mm.
inline constexpr double kFineSide = 0.03;

/// A link as the ground sees it.
struct LinkCorners {
  double radius = 0;  ///< m, from the centre of mass to the farthest corner
  /// m, of the box along the link's axes about all of its boxes.
  Eigen::Vector3d centre, half;
  std::vector<BoxCorners> boxes;
};

LinkCorners CornersOf(const Link& link);

struct GroundContact {
  int module = 0;            ///< index into Body::modules
  double depth = 0;          ///< m, at least 0
  Eigen::Vector3d position;  ///< m, world frame
  Eigen::Vector3d normal;    ///< unit, out of the ground
  /// Tells the point from the link's others, and stays while it touches.
  int key = 0;
};

/// Where a link is: its centre of mass, and its axes as columns.
struct LinkPose {
  Eigen::Vector3d position;
  Eigen::Matrix3d axes;
};

/// Appends every corner on or below the ground.
void AppendGroundContacts(const LinkCorners& link, const LinkPose& pose,
                          const Eigen::Vector3d& normal,
                          std::vector<GroundContact>& contacts);

/// On rough ground, of the points of BoxCorners::fine; depth and normal are to
/// the tangent plane at the point. Hills narrower than the points are apart
/// may reach into a box from below unseen.
void AppendRoughContacts(const LinkCorners& link, const LinkPose& pose,
                         const HeightField& field,
                         std::vector<GroundContact>& contacts);

/// A few contacts without memory of the heap, which every step would ask for.
struct FewContacts {
  std::array<GroundContact, kMaxGroundContacts> contacts;
  std::size_t count = 0;

  void Add(const GroundContact& contact) { contacts.at(count++) = contact; }
  const GroundContact* begin() const { return contacts.data(); }
  const GroundContact* end() const { return contacts.data() + count; }
};

/// At most kMaxGroundContacts of them: the deepest, the one farthest from it,
/// and the two that widen the support most. Fewer if the rest adds no width.
FewContacts Spanning(const std::vector<GroundContact>& contacts,
                     const Eigen::Vector3d& normal);

}  // namespace plsc
