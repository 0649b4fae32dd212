// A module's place is the way of slots that leads to it from the core: the same
// place is the same module, whatever was mounted before it. So a body is a set
// of words over four letters, and two bodies are compared as sets. Cells would
// not do: sensors have none, and two ways can lead to one cell, so that a limb
// of one body would be taken for part of another limb of the other.

#include "runtime/compare/body_difference.h"

#include <map>
#include <string>

namespace plsc {

std::vector<std::string> PlacesOf(const Body& body) {
  std::vector<std::string> places;
  for (const Module& module : body.modules)  // parents precede children
    places.push_back(
        module.parent == kNoModule
            ? std::string()
            : places[static_cast<std::size_t>(module.parent)] +
                  static_cast<char>('0' + static_cast<int>(module.slot)));
  return places;
}

BodyDifference CompareBodies(const Body& reference, const Body& body) {
  const std::vector<std::string> known = PlacesOf(reference);
  const std::vector<std::string> places = PlacesOf(body);
  std::map<std::string, std::size_t> found;
  for (std::size_t i = 0; i < known.size(); ++i) found.emplace(known[i], i);

  BodyDifference difference;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto there = found.find(places[i]);
    if (there == found.end()) {
      difference.marks.push_back(ModuleMark::kNew);
      continue;
    }
    const Module& one = reference.modules[there->second];
    const Module& other = body.modules[i];
    const bool is_same =
        one.type == other.type && one.angle_deg == other.angle_deg;
    difference.marks.push_back(is_same ? ModuleMark::kShared
                                       : ModuleMark::kOther);
  }
  for (const std::string& place : places) found.erase(place);
  for (std::size_t i = 0; i < known.size(); ++i)
    if (found.contains(known[i]))
      difference.missing.push_back(static_cast<int>(i));
  return difference;
}

}  // namespace plsc
