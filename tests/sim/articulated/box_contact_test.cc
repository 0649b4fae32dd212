#include "sim/articulated/box_contact.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

namespace plsc {
namespace {

struct Touch {
  std::array<BoxContact, kMostBoxContacts> contacts;
  int count = 0;
  double gap = 0;
};

Touch TouchOf(const OrientedBox& a, const OrientedBox& b) {
  Touch touch;
  touch.count = CollideBoxes(a, b, touch.contacts, touch.gap);
  return touch;
}

std::set<int> KeysOf(const Touch& touch) {
  std::set<int> keys;
  for (int i = 0; i < touch.count; ++i)
    keys.insert(touch.contacts.at(static_cast<std::size_t>(i)).key);
  return keys;
}

/// A cube of 2 m, turned about z.
OrientedBox CubeAt(double x, double y, double z, double turn = 0) {
  const double c = std::cos(turn), s = std::sin(turn);
  return {{x, y, z}, {{c, s, 0}, {-s, c, 0}, {0, 0, 1}}, {1, 1, 1}};
}

TEST_CASE("Boxes that lie on each other touch at corners", "[box_contact]") {
  struct Row {
    const char* why;
    OrientedBox first, second;
    int count;
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
    CHECK(KeysOf(touch).size() == static_cast<std::size_t>(touch.count));
    for (int i = 0; i < touch.count; ++i) {
      const BoxContact& contact =
          touch.contacts.at(static_cast<std::size_t>(i));
      CHECK(contact.depth == Approx(row.depth).margin(1e-15));
    }
  }
}

}  // namespace
}  // namespace plsc
