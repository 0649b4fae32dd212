#include "runtime/store/constants.h"

#include <fmt/format.h>

#include <cassert>

#include "grammar/number.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/text/yaml_reader.h"

namespace plsc {

namespace {

/// "5 deg" and "0.8" are numbers; a quoted text, or "2x2", is none.
void TakeNumber(ScenarioConstant& constant) {
  const std::string& text = constant.text;
  const LeadingNumber<double> number = ReadNumber<double>(text);
  const std::string rest = text.substr(number.length);
  if (number.kind != LeadingNumber<double>::Kind::kFits ||
      (!rest.empty() && rest.front() != ' '))
    return;
  constant.number = number.value;
  if (!rest.empty()) constant.unit = rest.substr(1);
}

void Collect(const YamlValue& value, const std::string& name,
             std::vector<ScenarioConstant>& constants) {
  if (value.is_scalar()) {
    ScenarioConstant constant{name, value.text(), std::nullopt, std::nullopt};
    if (!value.is_quoted()) TakeNumber(constant);
    constants.push_back(std::move(constant));
  } else if (value.is_map()) {
    std::optional<YamlMap> map = value.Map("constants");
    for (const YamlMap::Entry& entry : map->TakeAll())
      Collect(entry.value, name + "." + entry.key, constants);
  } else if (const auto items = value.List("constants")) {
    for (std::size_t i = 0; i < items->size(); ++i)
      Collect((*items)[i], fmt::format("{}.{}", name, i), constants);
  }
}

}  // namespace

std::vector<ScenarioConstant> ConstantsOf(const Scenario& scenario,
                                          const Season& season) {
  Scenario alone = scenario;
  alone.seasons = {season};
  const Source yaml("scenario", PrintScenario(alone));
  const YamlFile file(yaml);
  std::optional<YamlMap> root = file.Root("a scenario");
  assert(root);
  std::vector<ScenarioConstant> constants;
  for (const YamlMap::Entry& entry : root->TakeAll()) {
    if (entry.key == "name") continue;  // of no consequence
    if (entry.key != "seasons") {
      Collect(entry.value, entry.key, constants);
      continue;
    }
    const auto seasons = entry.value.List("seasons");
    assert(seasons && seasons->size() == 1);
    std::optional<YamlMap> own = seasons->front().Map("a season");
    for (const YamlMap::Entry& constant : own->TakeAll())
      if (constant.key != "name")
        Collect(constant.value, constant.key, constants);
  }
  assert(file.diagnostics().empty());
  return constants;
}

}  // namespace plsc
