#include "sim/ground.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <set>

#include "tests/sim/bodies.h"

namespace plsc {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::vector<GroundContact> ContactsAt(const LinkPose& pose,
                                      const Terrain& terrain) {
  const LinkCorners core = CornersOf(Assemble(LoneCore()).links[0]);
  std::vector<GroundContact> contacts;
  AppendGroundContacts(core, pose, GroundNormal(terrain), contacts);
  return contacts;
}

TEST_CASE("The ground rises along y by its tilt", "[ground]") {
  CHECK(GroundNormal({}) == Vector3d::UnitZ());
  // The tilt of a flat terrain is without meaning.
  CHECK(GroundNormal({TerrainType::kFlat, 0.3}) == Vector3d::UnitZ());
  const double tilt = 0.1;
  const Vector3d normal = GroundNormal({TerrainType::kTilted, tilt});
  CHECK(normal.norm() == Approx(1));
  const Vector3d uphill(0, std::cos(tilt), std::sin(tilt));
  CHECK(normal.dot(uphill) == Approx(0).margin(1e-15));
}

TEST_CASE("Corners below the ground are contacts, with their depth",
          "[ground]") {
  const Matrix3d upright = Matrix3d::Identity();
  const Matrix3d on_corner =
      Eigen::Quaterniond::FromTwoVectors(Vector3d(0.089, 0.089, 0.045),
                                         -Vector3d::UnitZ())
          .toRotationMatrix();
  const double radius = Vector3d(0.089, 0.089, 0.045).norm() / 2;
  struct Row {
    const char* why;
    LinkPose pose;
    std::size_t count;
    double depth;
  };
  const Row rows[] = {
      {"above", {{0, 0, 0.0226}, upright}, 0, 0},
      {"beyond its radius", {{0, 0, 1}, upright}, 0, 0},
      {"lying 1 mm deep", {{0, 0, 0.0215}, upright}, 4, 0.001},
      {"wholly below", {{0, 0, -0.1}, upright}, 8, 0.1225},
      {"on a corner", {{0, 0, radius - 0.002}, on_corner}, 1, 0.002},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const auto contacts = ContactsAt(row.pose, {});
    REQUIRE(contacts.size() == row.count);
    double deepest = 0;
    for (const GroundContact& contact : contacts) {
      deepest = std::max(deepest, contact.depth);
      CHECK(contact.depth == Approx(-contact.position.z()).margin(1e-15));
    }
    CHECK(deepest == Approx(row.depth).margin(1e-12));
  }
}

TEST_CASE("On a slope only the uphill corners of an upright core touch",
          "[ground]") {
  const Terrain slope{TerrainType::kTilted, 5 * M_PI / 180};
  const auto contacts =
      ContactsAt({{0, 0, 0.024}, Matrix3d::Identity()}, slope);
  REQUIRE(contacts.size() == 2);
  for (const GroundContact& contact : contacts) CHECK(contact.position.y() > 0);
}

TEST_CASE("Spanning keeps the support of a link", "[ground]") {
  const auto at = [](double x, double y, double depth = 0) {
    return GroundContact{0, depth, {x, y, -depth}, Vector3d::UnitZ()};
  };
  struct Row {
    const char* why;
    std::vector<GroundContact> contacts;
    std::set<std::pair<double, double>> kept;
  };
  const Row rows[] = {
      {"no contact", {}, {}},
      {"four are all kept, even in line",
       {at(0, 0), at(1, 0), at(2, 0), at(3, 0)},
       {{0, 0}, {1, 0}, {2, 0}, {3, 0}}},
      {"in line: the deepest and the farthest from it",
       {at(0, 0), at(1, 0, 1e-3), at(2, 0), at(3, 0), at(4, 0)},
       {{1, 0}, {4, 0}}},
      {"a square with points inside",
       {at(0.5, 0.4), at(0, 0, 1e-3), at(1, 0), at(0.2, 0.6), at(1, 1),
        at(0, 1)},
       {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      {"a triangle with points inside",
       {at(0, 0, 1e-3), at(4, 0), at(0, 3), at(1, 1), at(0.5, 0.5)},
       {{0, 0}, {4, 0}, {0, 3}}},
      {"the fourth may lie beyond any edge of the first three",
       {at(0, 0, 1e-3), at(4, 0), at(0, 4), at(3, 2.5), at(1, 1)},
       {{0, 0}, {4, 0}, {0, 4}, {3, 2.5}}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    std::set<std::pair<double, double>> kept;
    for (const GroundContact& contact :
         Spanning(row.contacts, Vector3d::UnitZ()))
      kept.insert({contact.position.x(), contact.position.y()});
    CHECK(kept == row.kept);
  }
}

}  // namespace
}  // namespace plsc
