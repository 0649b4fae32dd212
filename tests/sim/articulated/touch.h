#pragma once

// What CollideBoxes tells of two boxes, as one value.

#include <array>
#include <cstddef>
#include <set>

#include "sim/articulated/box_contact.h"

namespace plsc::test {

struct Touch {
  std::array<BoxContact, kMostBoxContacts> contacts;
  std::size_t count = 0;
  double gap = 0;

  const BoxContact* begin() const { return contacts.data(); }
  const BoxContact* end() const { return contacts.data() + count; }
  const BoxContact& first() const { return contacts[0]; }

  std::set<int> Keys() const {
    std::set<int> keys;
    for (const BoxContact& contact : *this) keys.insert(contact.key);
    return keys;
  }
};

inline Touch TouchOf(const OrientedBox& a, const OrientedBox& b) {
  Touch touch;
  touch.count =
      static_cast<std::size_t>(CollideBoxes(a, b, touch.contacts, touch.gap));
  return touch;
}

}  // namespace plsc::test
