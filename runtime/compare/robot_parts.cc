// Which part of one robot is which of the other? Ids are numbered in the order
// of mounting, so a module that is mounted early renumbers all that follow, and
// by ids everything would look changed. So modules are matched by where they
// are (their cell, a sensor by its parent's cell and side), what is left by id
// and type, which finds those that moved. Nodes follow the module that they
// belong to, edges follow their nodes, and what hangs on a module that was
// added or is missing is not told again. Numbers that shifted are one line of
// their own.
//
// Everything is handed out once and in order (Pool), so that each part has one
// partner at most. Two edges with the same ends are told apart by their order,
// which is compared, too: weights are summed in it. Parts times their
// logarithm.

#include "runtime/compare/robot_parts.h"
#include "grammar/number.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace plsc {

namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// By index of `from`: the index of `to` that it became, or kNone.
struct Matching {
  std::vector<std::size_t> to;
  std::vector<bool> is_taken;  // by index of `to`

  Matching(std::size_t from_size, std::size_t to_size)
      : to(from_size, kNone), is_taken(to_size, false) {}
  void Match(std::size_t from, std::size_t found) {
    to[from] = found;
    is_taken[found] = true;
  }
};

// Indices by a key, each handed out once, in order.
template <typename Key>
class Pool {
 public:
  void Add(Key key, std::size_t index) {
    free_[std::move(key)].push_back(index);
  }
  std::size_t Take(const Key& key) {
    const auto found = free_.find(key);
    if (found == free_.end() || found->second.size() == taken_[key])
      return kNone;
    return found->second[taken_[key]++];
  }

 private:
  std::map<Key, std::vector<std::size_t>> free_;
  std::map<Key, std::size_t> taken_;
};

// A robot whose parts can be found by id.
struct Indexed {
  const GoldenRobot& robot;
  std::map<std::string_view, std::size_t> modules;
  std::map<std::string_view, std::size_t> nodes;

  explicit Indexed(const GoldenRobot& given) : robot(given) {
    for (std::size_t i = 0; i < robot.modules.size(); ++i)
      modules.emplace(robot.modules[i].id, i);
    for (std::size_t i = 0; i < robot.nodes.size(); ++i)
      nodes.emplace(robot.nodes[i].id, i);
  }
  std::optional<std::size_t> Module(std::string_view id) const {
    const auto found = modules.find(id);
    if (found == modules.end()) return std::nullopt;
    return found->second;
  }
  std::optional<std::size_t> Node(std::string_view id) const {
    const auto found = nodes.find(id);
    if (found == nodes.end()) return std::nullopt;
    return found->second;
  }
};

std::string CellText(const GoldenCell& cell) {
  return fmt::format("x={},y={}", cell.x, cell.y);
}

// Where a module is, as key and as text: its cell, or the side of the module
// that a sensor sits on.
std::string Place(const Indexed& indexed, const GoldenModule& module) {
  if (module.cell) return CellText(*module.cell);
  const auto parent = indexed.Module(module.parent);
  const auto cell = parent ? indexed.robot.modules[*parent].cell : std::nullopt;
  return fmt::format("{} of {}", module.slot,
                     cell ? CellText(*cell) : "module " + module.parent);
}

// "module 7 (A1 at x=1,y=0)".
std::string Name(const Indexed& indexed, const GoldenModule& module) {
  return fmt::format("module {} ({} at {})", module.id, module.type,
                     Place(indexed, module));
}

// "node3 (A1 at x=1,y=0)".
std::string Name(const Indexed& indexed, const GoldenNode& node) {
  const auto index = indexed.Module(node.module);
  if (!index) return node.id + " of module " + node.module;
  const GoldenModule& module = indexed.robot.modules[*index];
  return fmt::format("{} ({} at {})", node.id, module.type,
                     Place(indexed, module));
}

std::string Name(const GoldenEdge& edge) {
  return "edge " + edge.source + "->" + edge.destination;
}

// What both sides of a comparison share while it runs.
class RobotComparison {
 public:
  RobotComparison(const GoldenRobot& expected, const GoldenRobot& found,
                  std::vector<Difference>& differences)
      : e_(expected),
        f_(found),
        modules_(expected.modules.size(), found.modules.size()),
        nodes_(expected.nodes.size(), found.nodes.size()),
        differences_(differences) {}

  void Modules();
  void Nodes();
  void Edges();

 private:
  using EdgeKey = std::pair<std::string_view, std::string_view>;

  void MatchModules();
  void CompareModule(const GoldenModule& expected, const GoldenModule& found);
  bool IsSameParent(const GoldenModule& expected,
                    const GoldenModule& found) const;
  void MatchNodes();
  void CompareNode(const GoldenNode& expected, const GoldenNode& found);
  std::optional<EdgeKey> KeyInFound(const GoldenEdge& edge) const;
  bool IsImplied(const Indexed& side, const GoldenEdge& edge) const;
  void CompareEdgeOrder(const Matching& edges);
  bool HasUnmatchedModule(const Indexed& side, std::string_view id) const;

  void Changed(std::string what, std::string expected, std::string found) {
    if (expected != found)
      differences_.push_back({DifferenceKind::kChanged, std::move(what),
                              std::move(expected), std::move(found)});
  }
  void Changed(const std::string& what, double expected, double found) {
    if (expected != found)
      Changed(what, PrintNumber(expected), PrintNumber(found));
  }
  void Only(DifferenceKind kind, std::string what) {
    differences_.push_back({kind, std::move(what), "", ""});
  }
  template <typename Part>
  void Renumbered(const char* what, const std::vector<Part>& expected,
                  const std::vector<Part>& found, const Matching& matching);

  Indexed e_;
  Indexed f_;
  Matching modules_;
  Matching nodes_;
  std::vector<Difference>& differences_;
};

void RobotComparison::MatchModules() {
  Pool<std::string> places;
  for (std::size_t i = 0; i < f_.robot.modules.size(); ++i)
    places.Add(Place(f_, f_.robot.modules[i]), i);
  for (std::size_t i = 0; i < e_.robot.modules.size(); ++i) {
    const std::size_t same = places.Take(Place(e_, e_.robot.modules[i]));
    if (same != kNone) modules_.Match(i, same);
  }
  for (std::size_t i = 0; i < e_.robot.modules.size(); ++i) {
    if (modules_.to[i] != kNone) continue;
    const GoldenModule& module = e_.robot.modules[i];
    const auto same = f_.Module(module.id);
    if (same && !modules_.is_taken[*same] &&
        f_.robot.modules[*same].type == module.type)
      modules_.Match(i, *same);
  }
}

bool RobotComparison::IsSameParent(const GoldenModule& expected,
                                   const GoldenModule& found) const {
  if (expected.slot != found.slot) return false;
  const auto e = e_.Module(expected.parent);
  const auto f = f_.Module(found.parent);
  if (!e || !f) return expected.parent == found.parent;
  return modules_.to[*e] == *f;
}

void RobotComparison::CompareModule(const GoldenModule& expected,
                                    const GoldenModule& found) {
  const std::string name = Name(e_, expected);
  const std::string place = Place(e_, expected);
  const std::string new_place = Place(f_, found);
  if (expected.type != found.type)
    Changed(fmt::format("type of module {} at {}", expected.id, place),
            expected.type, found.type);
  if (place != new_place)
    differences_.push_back(
        {DifferenceKind::kMoved,
         fmt::format("module {} ({})", expected.id, expected.type), place,
         new_place});
  Changed("facing of " + name, expected.facing, found.facing);
  Changed("angle of " + name, expected.angle_deg, found.angle_deg);
  // Another place or facing has another parent or slot anyway.
  if (place == new_place && expected.facing == found.facing &&
      !IsSameParent(expected, found))
    differences_.push_back({DifferenceKind::kChanged, "parent of " + name,
                            expected.parent + " " + expected.slot,
                            found.parent + " " + found.slot});
}

// Numbers alone, which move on when something is mounted earlier.
template <typename Part>
void RobotComparison::Renumbered(const char* what,
                                 const std::vector<Part>& expected,
                                 const std::vector<Part>& found,
                                 const Matching& matching) {
  std::string before;
  std::string after;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (matching.to[i] == kNone) continue;
    const Part& same = found[matching.to[i]];
    if (expected[i].id == same.id) continue;
    before += (before.empty() ? "" : " ") + expected[i].id;
    after += (after.empty() ? "" : " ") + same.id;
  }
  Changed(what, before, after);
}

void RobotComparison::Modules() {
  MatchModules();
  const auto& expected = e_.robot.modules;
  const auto& found = f_.robot.modules;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (modules_.to[i] == kNone)
      Only(DifferenceKind::kMissing, Name(e_, expected[i]));
    else
      CompareModule(expected[i], found[modules_.to[i]]);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!modules_.is_taken[i]) Only(DifferenceKind::kAdded, Name(f_, found[i]));
  Renumbered("numbers of modules", expected, found, modules_);
}

void RobotComparison::MatchNodes() {
  Pool<std::string_view> by_module;
  for (std::size_t i = 0; i < f_.robot.nodes.size(); ++i)
    by_module.Add(f_.robot.nodes[i].module, i);
  for (std::size_t i = 0; i < e_.robot.nodes.size(); ++i) {
    const auto module = e_.Module(e_.robot.nodes[i].module);
    if (!module || modules_.to[*module] == kNone) continue;
    const std::size_t same =
        by_module.Take(f_.robot.modules[modules_.to[*module]].id);
    if (same != kNone) nodes_.Match(i, same);
  }
}

void RobotComparison::CompareNode(const GoldenNode& expected,
                                  const GoldenNode& found) {
  const std::string of = " of " + Name(e_, expected);
  const auto type = [](const GoldenNode& node) {
    return node.is_oscillator ? "oscillator" : "input";
  };
  Changed("type" + of, std::string(type(expected)), std::string(type(found)));
  Changed("weight" + of, expected.weight, found.weight);
  if (expected.is_oscillator != found.is_oscillator) return;
  Changed("amplitude" + of, expected.amplitude, found.amplitude);
  Changed("period" + of, expected.period, found.period);
  Changed("phase offset" + of, expected.phase_offset, found.phase_offset);
}

// Whether the module of this id is one that was added or is missing.
bool RobotComparison::HasUnmatchedModule(const Indexed& side,
                                         std::string_view id) const {
  const auto index = side.Module(id);
  if (!index) return false;
  return &side == &e_ ? modules_.to[*index] == kNone
                      : !modules_.is_taken[*index];
}

void RobotComparison::Nodes() {
  MatchNodes();
  const auto& expected = e_.robot.nodes;
  const auto& found = f_.robot.nodes;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (nodes_.to[i] != kNone)
      CompareNode(expected[i], found[nodes_.to[i]]);
    else if (!HasUnmatchedModule(e_, expected[i].module))
      Only(DifferenceKind::kMissing, Name(e_, expected[i]));
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!nodes_.is_taken[i] && !HasUnmatchedModule(f_, found[i].module))
      Only(DifferenceKind::kAdded, Name(f_, found[i]));
  Renumbered("numbers of nodes", expected, found, nodes_);
}

// The ends of an expected edge under the ids of the found robot.
std::optional<RobotComparison::EdgeKey> RobotComparison::KeyInFound(
    const GoldenEdge& edge) const {
  const auto source = e_.Node(edge.source);
  const auto destination = e_.Node(edge.destination);
  if (!source || !destination) return std::nullopt;
  const std::size_t s = nodes_.to[*source];
  const std::size_t d = nodes_.to[*destination];
  if (s == kNone || d == kNone) return std::nullopt;
  return EdgeKey{f_.robot.nodes[s].id, f_.robot.nodes[d].id};
}

// Whether an end hangs on a module that was added or is missing.
bool RobotComparison::IsImplied(const Indexed& side,
                                const GoldenEdge& edge) const {
  for (const std::string& id : {edge.source, edge.destination}) {
    const auto node = side.Node(id);
    if (node && HasUnmatchedModule(side, side.robot.nodes[*node].module))
      return true;
  }
  return false;
}

// Inputs are summed in this order, so the last digits of a run depend on it.
void RobotComparison::CompareEdgeOrder(const Matching& edges) {
  std::size_t last = 0;
  for (const std::size_t found : edges.to) {
    if (found == kNone) continue;
    if (found < last)
      return Changed("order of edges", std::string("as recorded"),
                     std::string("another"));
    last = found;
  }
}

void RobotComparison::Edges() {
  const auto& expected = e_.robot.edges;
  const auto& found = f_.robot.edges;
  Matching edges(expected.size(), found.size());
  Pool<EdgeKey> by_ends;
  for (std::size_t i = 0; i < found.size(); ++i)
    by_ends.Add({found[i].source, found[i].destination}, i);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto key = KeyInFound(expected[i]);
    const std::size_t same = key ? by_ends.Take(*key) : kNone;
    if (same != kNone) {
      edges.Match(i, same);
      Changed("weight of " + Name(expected[i]), expected[i].weight,
              found[same].weight);
    } else if (!IsImplied(e_, expected[i])) {
      Only(DifferenceKind::kMissing, Name(expected[i]));
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!edges.is_taken[i] && !IsImplied(f_, found[i]))
      Only(DifferenceKind::kAdded, Name(found[i]));
  CompareEdgeOrder(edges);
}

}  // namespace

void CompareParts(const GoldenRobot& expected, const GoldenRobot& found,
                  std::vector<Difference>& differences) {
  RobotComparison comparison(expected, found, differences);
  comparison.Modules();
  comparison.Nodes();
  comparison.Edges();
}

}  // namespace plsc
