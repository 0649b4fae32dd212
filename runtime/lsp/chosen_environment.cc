#include "runtime/lsp/chosen_environment.h"

#include <algorithm>
#include <limits>

#include "compiler/environment_text.h"

namespace plsc::lsp {

std::vector<NamedEnvironment> EnvironmentsOf(const Section& section) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  std::vector<NamedEnvironment> environments;
  for (const ast::Environment& declared : section.file.environments) {
    std::vector<double> values(section.scope.header.states.size(), kMissing);
    for (std::uint32_t k = 0; k < declared.entries.count; ++k) {
      const ResolvedTerm& entry =
          section.resolution.entries[declared.entries.first + k];
      if (entry) values[static_cast<std::size_t>(entry->state)] = entry->value;
    }
    const bool is_complete =
        std::none_of(values.begin(), values.end(),
                     [](double value) { return value != value; });
    if (is_complete)
      environments.push_back(
          {std::string(section.file.Text(declared.name)), {std::move(values)}});
  }
  return environments;
}

std::optional<NamedEnvironment> ChosenFor(const Section& section,
                                          const std::string& chosen) {
  const std::vector<NamedEnvironment> known = EnvironmentsOf(section);
  if (chosen.empty()) {
    if (known.empty()) return std::nullopt;
    return known.front();
  }
  const auto named = std::find_if(
      known.begin(), known.end(),
      [&](const auto& environment) { return environment.name == chosen; });
  if (named != known.end()) return *named;
  // A text without '=' is a name that this section does not have.
  if (chosen.find('=') == std::string::npos) return std::nullopt;
  const Result<Environment> values = ParseEnvironment(
      Source("plsc.environment", chosen), section.scope.header.states);
  if (!values) return std::nullopt;
  return NamedEnvironment{chosen, *values};
}

}  // namespace plsc::lsp
