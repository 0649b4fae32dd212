// What is seen from straight above, without a third dimension: each box's
// shadow is the convex hull of its eight corners (Andrew's monotone chain,
// 1979), and shadows are painted from the lowest centre to the highest. That is
// not exact where boxes lean into each other, and right for parts that do not
// intersect and are small.

#include "runtime/pictures/top_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace plsc {

namespace {

Eigen::Quaterniond TurnOf(const Eigen::Vector4d& wxyz) {
  return Eigen::Quaterniond(wxyz(0), wxyz(1), wxyz(2), wxyz(3)).normalized();
}

struct Pose {
  Eigen::Vector3d position;
  Eigen::Quaterniond turn;
};

Pose PoseOf(const RecordedSeason& season, std::size_t link,
            Eigen::Index sample) {
  const Motion& motion = season.motion;
  if (motion.samples() == 0)
    return {season.body.links[link].rest, Eigen::Quaterniond::Identity()};
  const auto i = static_cast<Eigen::Index>(link);
  return {motion.position.col(sample).segment<3>(3 * i),
          TurnOf(motion.turn.col(sample).segment<4>(4 * i))};
}

std::vector<Eigen::Vector2d> Shadow(const RecordedBox& box, const Pose& pose) {
  const Eigen::Quaterniond turn = pose.turn * TurnOf(box.turn);
  const Eigen::Vector3d centre = pose.position + pose.turn * box.centre;
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d half(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5,
                               i & 4 ? 0.5 : -0.5);
    const Eigen::Vector3d corner =
        centre + turn * Eigen::Vector3d(half.cwiseProduct(box.size));
    corners.emplace_back(corner.x(), corner.y());
  }
  return ConvexHull(std::move(corners));
}

// Twice the area of the triangle, positive if a, b, c turn left.
double Turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
            const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

}  // namespace

std::vector<Eigen::Vector2d> ConvexHull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(),
            [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
              return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
            });
  // Along the lower side to the right, then along the upper one back.
  std::vector<Eigen::Vector2d> hull;
  for (const bool is_upper : {false, true}) {
    const std::size_t begin = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= begin + 2 &&
             Turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    if (!hull.empty()) hull.pop_back();  // the other side begins with it
    if (!is_upper) std::reverse(points.begin(), points.end());
  }
  return hull;
}

std::vector<Outline> TopView(const RecordedSeason& season,
                             Eigen::Index sample) {
  std::vector<std::pair<double, Outline>> by_height;
  for (std::size_t link = 0; link < season.body.links.size(); ++link) {
    const Pose pose = PoseOf(season, link, sample);
    for (const RecordedBox& box : season.body.links[link].boxes) {
      const auto module = static_cast<std::size_t>(box.module);
      by_height.emplace_back((pose.position + pose.turn * box.centre).z(),
                             Outline{season.body.modules[module].type, box.part,
                                     Shadow(box, pose)});
    }
  }
  std::stable_sort(
      by_height.begin(), by_height.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Outline> outlines;
  outlines.reserve(by_height.size());
  for (auto& [height, outline] : by_height)
    outlines.push_back(std::move(outline));
  return outlines;
}

}  // namespace plsc
