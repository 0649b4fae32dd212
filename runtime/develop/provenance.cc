// Two questions to a history. Back: which symbol made a part is kept by the
// trace, and who changed it is found by going through the events once. Forward:
// all insertions of one place of one rule, and what became of each, a place in
// the final string or the rewriting that replaced it.

#include "runtime/develop/provenance.h"

#include <algorithm>
#include <cctype>
#include <unordered_map>

namespace plsc {

namespace {

std::string NodeId(int index) {
  return "node" + std::to_string(index + 1);
}

bool StartsWithDigit(const std::string& text) {
  return !text.empty() &&
         std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

// "3" is "node3", "1-3" is "node1-node3".
std::string FullId(const PhenotypePart& part) {
  if (part.kind == PartKind::kModule || !StartsWithDigit(part.id))
    return part.id;
  const std::size_t dash = part.id.find('-');
  if (part.kind == PartKind::kNode || dash == std::string::npos)
    return "node" + part.id;
  return "node" + part.id.substr(0, dash) + "-node" + part.id.substr(dash + 1);
}

const std::vector<StringIndex>& OriginsOf(const Trace& trace, PartKind kind) {
  switch (kind) {
    case PartKind::kModule:
      return trace.module_origins;
    case PartKind::kNode:
      return trace.node_origins;
    case PartKind::kEdge:
      break;
  }
  return trace.edge_origins;
}

bool Changes(const Event& event, PartKind kind, int index) {
  if (kind == PartKind::kNode)
    return event.effect == Effect::kNeuronChanged && event.node == index;
  return kind == PartKind::kEdge && event.effect == Effect::kEdgeChanged &&
         event.edge == index;
}

}  // namespace

std::vector<std::string> IdsOf(const Phenotype& phenotype, PartKind kind) {
  std::vector<std::string> ids;
  switch (kind) {
    case PartKind::kModule:
      for (std::size_t i = 0; i < phenotype.body.modules.size(); ++i)
        ids.push_back(ModuleId(phenotype.body, static_cast<int>(i)));
      break;
    case PartKind::kNode:
      for (std::size_t i = 0; i < phenotype.brain.nodes.size(); ++i)
        ids.push_back(NodeId(static_cast<int>(i)));
      break;
    case PartKind::kEdge:
      for (const Connection& edge : phenotype.brain.connections)
        ids.push_back(NodeId(edge.source) + "-" + NodeId(edge.destination));
  }
  return ids;
}

std::optional<PartHistory> HistoryOf(const Trace& trace,
                                     const PhenotypePart& part) {
  PartHistory history;
  history.id = FullId(part);
  const std::vector<std::string> ids = IdsOf(trace.phenotype, part.kind);
  const auto found = std::find(ids.begin(), ids.end(), history.id);
  if (found == ids.end()) return std::nullopt;
  const auto index = static_cast<int>(found - ids.begin());
  history.origin = OriginsOf(trace, part.kind)[static_cast<std::size_t>(index)];
  for (std::size_t i = 0; i < trace.events.size(); ++i)
    if (Changes(trace.events[i], part.kind, index))
      history.changes.push_back(static_cast<StringIndex>(i));
  return history;
}

std::vector<Fate> FatesOf(const Derivation& derivation, RuleIndex rule,
                          std::uint32_t position) {
  std::unordered_map<InsertionId, StringIndex> places;
  for (std::size_t i = 0; i < derivation.string().size(); ++i)
    places[derivation.string()[i]] = static_cast<StringIndex>(i);
  std::vector<Fate> fates;
  for (std::size_t i = 0; i < derivation.insertions.size(); ++i) {
    const Insertion& insertion = derivation.insertions[i];
    if (insertion.occurrence.rule != rule ||
        insertion.occurrence.position != position)
      continue;
    Fate fate;
    fate.insertion = static_cast<InsertionId>(i);
    if (insertion.child_count > 0)
      fate.replaced_in = derivation[insertion.first_child].iteration;
    else
      fate.index = places.at(fate.insertion);
    fates.push_back(fate);
  }
  return fates;
}

}  // namespace plsc
