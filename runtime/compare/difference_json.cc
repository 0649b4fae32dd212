#include "runtime/compare/difference_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compiler/changes/merge_parts.h"
#include "grammar/enum_names.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

constexpr EnumNames<ItemChangeKind, 4> kItemChangeNames{
    {{ItemChangeKind::kAdded, "added"},
     {ItemChangeKind::kRemoved, "removed"},
     {ItemChangeKind::kMoved, "moved"},
     {ItemChangeKind::kChanged, "changed"}}};

Json LineJson(int line) {
  return line == 0 ? Json() : Json(line);
}

Json PartJson(const std::optional<PartContent>& part) {
  return part ? Json(PartText(*part)) : Json();
}

Json ItemJson(const ItemChange& change) {
  Json json;
  json["item"] = change.name;
  json["change"] = NameIn(kItemChangeNames, change.kind);
  json["old_line"] = LineJson(change.old_line);
  json["new_line"] = LineJson(change.new_line);
  json["old"] = change.before;
  json["new"] = change.after;
  json["parts"] = Json::array();
  for (std::size_t i = 0; i < change.parts.size(); ++i) {
    const PartChange& part = change.parts[i];
    if (part.before != part.after)
      json["parts"].push_back(
          {{"old", PartJson(part.before)}, {"new", PartJson(part.after)}});
  }
  return json;
}

Json EnvironmentJson(const EnvironmentDifference& environment) {
  Json json;
  json["environment"] = environment.where.text;
  json["names"] = environment.where.names;
  json["differences"] = Json::array();
  for (const Difference& difference : environment.differences)
    json["differences"].push_back({{"kind", KindName(difference.kind)},
                                   {"what", difference.what},
                                   {"old", difference.expected},
                                   {"new", difference.found}});
  return json;
}

}  // namespace

bool GenotypeDifference::is_different() const {
  return kind != ItemChangeKind::kChanged ||
         std::any_of(environments.begin(), environments.end(),
                     [](const EnvironmentDifference& one) {
                       return !one.differences.empty();
                     });
}

std::string DifferenceJson(const std::vector<SectionChange>& texts,
                           const std::vector<GenotypeDifference>& robots) {
  Json json;
  json["differs"] = std::any_of(
      robots.begin(), robots.end(),
      [](const GenotypeDifference& one) { return one.is_different(); });
  json["texts"] = Json::array();
  for (const SectionChange& section : texts) {
    Json items = Json::array();
    for (const ItemChange& change : section.items)
      items.push_back(ItemJson(change));
    json["texts"].push_back(
        {{"genotype", section.genotype}, {"changes", std::move(items)}});
  }
  json["robots"] = Json::array();
  for (const GenotypeDifference& one : robots) {
    Json environments = Json::array();
    for (const EnvironmentDifference& environment : one.environments)
      environments.push_back(EnvironmentJson(environment));
    json["robots"].push_back({{"genotype", one.genotype},
                              {"change", NameIn(kItemChangeNames, one.kind)},
                              {"differs", one.is_different()},
                              {"limitation", one.limitation},
                              {"environments", std::move(environments)}});
  }
  return json.dump();
}

}  // namespace plsc
