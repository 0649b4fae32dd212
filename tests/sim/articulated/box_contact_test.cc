#include "sim/articulated/box_contact.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/sim/articulated/touch.h"

namespace plsc {
namespace {

using test::Touch;
using test::TouchOf;

/// A cube of 2 m, turned about z.
OrientedBox CubeAt(double x, double y, double z, double turn = 0) {
  const double c = std::cos(turn), s = std::sin(turn);
  return {{x, y, z}, {{c, s, 0}, {-s, c, 0}, {0, 0, 1}}, {1, 1, 1}};
}

TEST_CASE("Boxes that lie on each other touch at corners", "[box_contact]") {
  struct Row {
    const char* why;
    OrientedBox first, second;
    std::size_t count;
    double depth;
  };
  const Row rows[] = {
      {"stacked", CubeAt(0, 0, 1.99), CubeAt(0, 0, 0), 4, 0.01},
      {"stacked aside", CubeAt(0.5, 0.3, 1.99), CubeAt(0, 0, 0), 4, 0.01},
      {"without penetration", CubeAt(0, 0, 2), CubeAt(0, 0, 0), 4, 0},
      {"one edge in common", CubeAt(0, 2, 2), CubeAt(0, 0, 0), 2, 0},
      {"one corner in common", CubeAt(2, 2, 2), CubeAt(0, 0, 0), 1, 0},
      {"turned by 45 degrees, an octagon", CubeAt(0, 0, 1.99, M_PI / 4),
       CubeAt(0, 0, 0), 4, 0.01},
      {"apart", CubeAt(0, 0, 2.001), CubeAt(0, 0, 0), 0, 0},
      {"apart by far", CubeAt(10, 20, 30), CubeAt(0, 0, 0), 0, 0},
      {"equal", CubeAt(0, 0, 0), CubeAt(0, 0, 0), 4, 2},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const Touch touch = TouchOf(row.first, row.second);
    CHECK(touch.count == row.count);
    CHECK((touch.gap > 0) == (row.count == 0));
    CHECK(touch.Keys().size() == touch.count);
    for (const BoxContact& contact : touch)
      CHECK(contact.depth == Approx(row.depth).margin(1e-15));
  }
}

/// A bar of 2 m along `side`, 0.2 m thick, an edge of it up.
OrientedBox BarOnEdge(int side, double z) {
  const double h = std::sqrt(0.5);
  OrientedBox bar{{0, 0, z}, {}, {0.1, 0.1, 0.1}};
  const int other = 1 - side;
  bar.half[0] = 1;
  bar.axes[0][side] = 1;
  bar.axes[1][other] = h;
  bar.axes[1][2] = h;
  bar.axes[2][other] = -h;
  bar.axes[2][2] = h;
  return bar;
}

TEST_CASE("Crossed bars touch between their edges", "[box_contact]") {
  const double height = 0.1 * std::sqrt(2);
  const OrientedBox lower = BarOnEdge(0, 0);
  OrientedBox upper = BarOnEdge(1, 2 * height - 0.01);
  upper.centre[0] = 0.3;
  upper.centre[1] = 0.4;
  const Touch touch = TouchOf(upper, lower);
  REQUIRE(touch.count == 1);
  const BoxContact& contact = touch.contacts[0];
  CHECK(contact.depth == Approx(0.01));
  // The first box goes up.
  CHECK(contact.normal[0] == Approx(0).margin(1e-15));
  CHECK(contact.normal[1] == Approx(0).margin(1e-15));
  CHECK(contact.normal[2] == Approx(1));
  CHECK(contact.position[0] == Approx(0.3));
  CHECK(contact.position[1] == Approx(0).margin(1e-15));
  CHECK(contact.position[2] == Approx(height - 0.005));
  CHECK(contact.key >= 12 * 6 * 24);
  CHECK(contact.key < kBoxContactKeys);

  upper.centre[2] = 2 * height + 0.01;
  CHECK(TouchOf(upper, lower).count == 0);
  CHECK(TouchOf(upper, lower).gap == Approx(0.01));
  // Which sides alone do not see.
  CHECK(BoxGapBound(upper, lower) <= 0);
}

TEST_CASE("A box within another is pushed the shortest way out",
          "[box_contact]") {
  OrientedBox small = CubeAt(0.5, 0.1, -0.2);
  for (double& half : small.half) half = 0.1;
  const Touch touch = TouchOf(small, CubeAt(0, 0, 0));
  REQUIRE(touch.count == 4);
  for (const BoxContact& contact : touch) {
    CHECK(contact.depth == Approx(0.6));
    CHECK(contact.normal[0] == 1);
    CHECK(contact.normal[1] == 0);
    CHECK(contact.normal[2] == 0);
  }
}

TEST_CASE("Boxes that are apart along a side are so by the gap",
          "[box_contact]") {
  CHECK(BoxGapBound(CubeAt(0, 0, 2.5), CubeAt(0, 0, 0)) == 0.5);
  CHECK(BoxGapBound(CubeAt(0, 3, 2.5), CubeAt(0, 0, 0)) == 1);
  CHECK(BoxGapBound(CubeAt(0, 0, 1.5), CubeAt(0, 0, 0)) == -0.5);
}

TEST_CASE("A number that is none touches nothing", "[box_contact]") {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  for (int number = 0; number < 15; ++number)
    for (const bool is_first : {false, true}) {
      OrientedBox broken = CubeAt(0, 0, 1.99, 0.1);
      (number < 3    ? broken.centre[number]
       : number < 12 ? broken.axes[number / 3 - 1][number % 3]
                     : broken.half[number - 12]) = nothing;
      const OrientedBox whole = CubeAt(0, 0, 0);
      INFO(number << " of the " << (is_first ? "first" : "second"));
      CHECK(
          (is_first ? TouchOf(broken, whole) : TouchOf(whole, broken)).count ==
          0);
    }
}

}  // namespace
}  // namespace plsc
