#include "runtime/compare/brain_difference.h"

#include <cstddef>
#include <map>
#include <string>

namespace plsc {

namespace {

/// What makes each node and each edge the same one in another robot.
struct BrainPlaces {
  std::vector<std::string> nodes;
  std::vector<std::string> edges;
};

BrainPlaces PlacesOf(const Phenotype& robot) {
  const std::vector<std::string> modules = PlacesOf(robot.body);
  BrainPlaces places;
  for (const Node& node : robot.brain.nodes)
    places.nodes.push_back(
        modules[static_cast<std::size_t>(node.module)] +
        (node.type == NodeType::kInput ? " input" : " oscillator"));
  std::map<std::string, int> count;  // two edges may join the same nodes
  for (const Connection& edge : robot.brain.connections) {
    std::string place =
        places.nodes[static_cast<std::size_t>(edge.source)] + " to " +
        places.nodes[static_cast<std::size_t>(edge.destination)];
    const int number = count[place]++;
    places.edges.push_back(place + " " + std::to_string(number));
  }
  return places;
}

bool IsSame(const Phenotype& reference, const Node& one, const Phenotype& robot,
            const Node& other) {
  const auto type_of = [](const Phenotype& of, const Node& node) {
    return of.body.modules[static_cast<std::size_t>(node.module)].type;
  };
  return type_of(reference, one) == type_of(robot, other) &&
         one.weight == other.weight && one.amplitude == other.amplitude &&
         one.period == other.period && one.phase_offset == other.phase_offset;
}

/// `is_same(i, k)`: whether part i of the reference equals part k.
template <typename Same>
void Compare(const std::vector<std::string>& reference,
             const std::vector<std::string>& places, const Same& is_same,
             std::vector<ModuleMark>& marks, std::vector<int>& missing) {
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < reference.size(); ++i)
    known.emplace(reference[i], i);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto there = known.find(places[k]);
    marks.push_back(there == known.end()        ? ModuleMark::kNew
                    : is_same(there->second, k) ? ModuleMark::kShared
                                                : ModuleMark::kOther);
  }
  for (const std::string& place : places) known.erase(place);
  for (std::size_t i = 0; i < reference.size(); ++i)
    if (known.contains(reference[i])) missing.push_back(static_cast<int>(i));
}

}  // namespace

BrainDifference CompareBrains(const Phenotype& reference,
                              const Phenotype& robot) {
  const BrainPlaces before = PlacesOf(reference);
  const BrainPlaces now = PlacesOf(robot);
  const Brain& a = reference.brain;
  const Brain& b = robot.brain;
  BrainDifference difference;
  Compare(
      before.nodes, now.nodes,
      [&](std::size_t i, std::size_t k) {
        return IsSame(reference, a.nodes[i], robot, b.nodes[k]);
      },
      difference.nodes, difference.missing_nodes);
  Compare(
      before.edges, now.edges,
      [&](std::size_t i, std::size_t k) {
        return a.connections[i].weight == b.connections[k].weight;
      },
      difference.edges, difference.missing_edges);
  return difference;
}

}  // namespace plsc
