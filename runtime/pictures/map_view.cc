// Ground below a path, drawn only where it can be told apart: what is smaller
// than some pixels on the picture is left out, as it would be a grey of
// millions of elements. Boxes are cut to the picture, because steps go on for a
// kilometre and viewers lose precision there.

#include "runtime/pictures/map_view.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/height_field.h"
#include "sim/static_boxes.h"

namespace plsc {

namespace {

// px. What is smaller cannot be told apart, and would make files of millions
// of elements.
constexpr double kSmallest = 6;
constexpr double kGrey = 0.09;  // opacity of a box
constexpr double kShade = 20;   // px, side of a square of rough ground

std::string BoxesSvg(const Terrain& terrain, const MapView& view) {
  const double half = view.side / view.scale / 2;
  Eigen::AlignedBox3d bounds;
  // 1 m below the plane and 10 km above it: whatever the boxes' heights.
  bounds.extend(
      Eigen::Vector3d(view.centre.x() - half, view.centre.y() - half, -1));
  bounds.extend(
      Eigen::Vector3d(view.centre.x() + half, view.centre.y() + half, 1e4));
  std::vector<StaticBox> boxes;
  AppendStaticBoxes(terrain, bounds, boxes);
  // Steps lie upon each other, and their greys add up: never to black.
  const double opacity =
      terrain.type == TerrainType::kSteps
          ? std::min(kGrey, 0.6 / static_cast<double>(boxes.size()))
          : kGrey;
  std::string svg;
  for (const StaticBox& box : boxes) {
    const Eigen::Vector2d size = box.size.head<2>();
    // Steps go on for kilometres, which viewers draw badly.
    Eigen::Vector2d low = box.centre.head<2>() - size / 2;
    Eigen::Vector2d high = box.centre.head<2>() + size / 2;
    low = low.cwiseMax(view.centre - Eigen::Vector2d::Constant(1.1 * half));
    high = high.cwiseMin(view.centre + Eigen::Vector2d::Constant(1.1 * half));
    const Eigen::Vector2d a = view(low);
    const Eigen::Vector2d b = view(high);
    fmt::format_to(std::back_inserter(svg),
                   R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" )"
                   R"(height="{:.1f}" class="box" fill-opacity="{:.3g}"/>)"
                   "\n",
                   a.x(), b.y(), std::max(b.x() - a.x(), 0.0),
                   std::max(a.y() - b.y(), 0.0), opacity);
  }
  return svg;
}

std::string ShadesSvg(const Rough& rough, const MapView& view) {
  const HeightField field(rough);
  std::string svg;
  for (double y = 0; y < view.side; y += kShade) {
    for (double x = 0; x < view.side; x += kShade) {
      const Eigen::Vector2d shift(x + kShade / 2 - view.side / 2,
                                  view.side / 2 - y - kShade / 2);
      const Eigen::Vector2d place = view.centre + shift / view.scale;
      const double height = field.At(place.x(), place.y()).height;
      // The mean is at most an amplitude from 0, so that this is 0 to 1; or
      // not a number where there is no height to shade, which is the middle.
      const double share = height / (4 * rough.amplitude);
      const double level =
          std::isfinite(share) ? std::clamp(0.5 + share, 0.0, 1.0) : 0.5;
      const int grey = static_cast<int>(std::lround(200 + 55 * level));
      fmt::format_to(std::back_inserter(svg),
                     R"(<rect x="{:.0f}" y="{:.0f}" width="{}" height="{}" )"
                     R"(fill="#{:02x}{:02x}{:02x}"/>)"
                     "\n",
                     view.corner.x() + x, view.corner.y() + y, kShade, kShade,
                     grey, grey, grey);
    }
  }
  return svg;
}

}  // namespace

std::string GroundSvg(const Terrain& terrain, const MapView& view) {
  switch (terrain.type) {
    case TerrainType::kFlat:
    case TerrainType::kTilted:
      return "";
    case TerrainType::kRough:
      if (terrain.rough.amplitude <= 0 ||
          terrain.rough.wavelength * view.scale < 2 * kShade)
        return "";
      return ShadesSvg(terrain.rough, view);
    case TerrainType::kSteps:
      if (terrain.steps.depth * view.scale < kSmallest) return "";
      return BoxesSvg(terrain, view);
    case TerrainType::kObstacles:
      if (terrain.obstacles.spacing * view.scale < kSmallest) return "";
      return BoxesSvg(terrain, view);
  }
  return "";
}

double RoundLength(double pixels, double scale) {
  const double most = pixels / scale;
  double power = 1;
  while (power > most && power > 1e-300) power /= 10;
  while (power * 10 <= most && power < 1e300) power *= 10;
  for (const double factor : {5.0, 2.0})
    if (factor * power <= most) return factor * power;
  return power;
}

}  // namespace plsc
