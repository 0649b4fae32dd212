// The whole of box_contact.cc and face_polygon.cc once more, compiled in
// another way. The macro `plsc` gives its names another namespace.

#include <algorithm>
#include <vector>

#include "sim/articulated/box_contact.cc"
#include "sim/articulated/face_polygon.cc"
#include "sim/fnv.h"

namespace plsc {

std::uint64_t HashOfContacts(const std::vector<double>& numbers);

/// Of what touches where, for boxes of 15 numbers each.
std::uint64_t HashOfContacts(const std::vector<double>& numbers) {
  Fnv hash;
  const auto box_at = [&](std::size_t place) {
    OrientedBox box;
    std::copy_n(&numbers[place], 3, box.centre);
    for (std::size_t i = 0; i < 3; ++i)
      std::copy_n(&numbers[place + 3 + 3 * i], 3, box.axes[i]);
    std::copy_n(&numbers[place + 12], 3, box.half);
    return box;
  };
  for (std::size_t i = 0; i < numbers.size(); i += 30) {
    std::array<BoxContact, kMostBoxContacts> contacts;
    double gap = 0;
    const int count = CollideBoxes(box_at(i), box_at(i + 15), contacts, gap);
    hash.Add(gap);
    for (int c = 0; c < count; ++c) {
      const BoxContact& contact = contacts[static_cast<std::size_t>(c)];
      for (const double x : contact.position) hash.Add(x);
      for (const double x : contact.normal) hash.Add(x);
      hash.Add(contact.depth);
      hash.Add(static_cast<double>(contact.key));
    }
  }
  return hash.value();
}

}  // namespace plsc
