#pragma once

// How deep a box is in rough ground, by brute force: the field itself at many
// points.

#include "sim/articulated/box_contact.h"
#include "sim/height_field.h"

namespace plsc::test {

/// Of `per_side` by `per_side` points on each face, corners among them, the
/// deepest below the tangent plane at its foot, m; negative if all are above.
double DeepestSample(const OrientedBox& box, const HeightField& field,
                     int per_side);

/// m from a point below the ground to the nearest point of the surface.
double NearestSurface(const HeightField& field, const double (&point)[3]);

}  // namespace plsc::test
