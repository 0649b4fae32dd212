#pragma once

// Whether a robot can exist: boxes of different links must not intersect in
// the rest pose. The grid of development has unit cells but a core is 89 mm,
// a joint 38.8 mm and a brick 38 mm long, so about one random robot in twenty
// cannot. The authors' program asks its physics engine (BodyAnalyzer.cpp);
// here it is geometry. Links that share a hinge may intersect.

#include <vector>

#include "sim/assembly.h"

namespace plsc {

/// m. Boxes that only touch, or would but for rounding, do not overlap.
inline constexpr double kOverlapTolerance = 1e-7;

/// By the separating axes of two boxes: their 6 face normals and the 9
/// products of their edges. True if they intersect deeper than the tolerance.
bool BoxesOverlap(const Box& a, const Box& b);

/// Two boxes, each the `box`-th of the `link`-th link.
struct Overlap {
  int link_a = 0, box_a = 0;
  int link_b = 0, box_b = 0;
};

std::vector<Overlap> FindOverlaps(const Assembly& assembly);

/// Pairs of links that can collide, a < b: all but those sharing a hinge.
struct LinkPair {
  int a = 0, b = 0;
};
std::vector<LinkPair> CollidingPairs(const Assembly& assembly);

}  // namespace plsc
