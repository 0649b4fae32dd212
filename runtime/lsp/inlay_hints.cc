#include "runtime/lsp/inlay_hints.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/lower.h"
#include "compiler/print.h"
#include "compiler/truth.h"
#include "grammar/shown_line.h"
#include "runtime/lsp/chosen_environment.h"
#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

// Characters of an environment that are shown: there may be a thousand states,
// and as many rules.
constexpr std::size_t kMaxShown = 400;

// Where a rule stands among the active ones of its symbol.
struct Activity {
  bool is_active = false;
  int number = 0;  ///< from 1, in the order of joining
  int count = 0;   ///< active rules of the symbol
};

// Nothing when some term could not be resolved.
std::optional<bool> Holds(const Section& section, const ast::Rule& rule,
                          const Environment& environment) {
  for (std::uint32_t k = 0; k < rule.terms.count; ++k)
    if (!section.resolution.terms[rule.terms.first + k]) return std::nullopt;
  return ClauseHolds(LowerClause(section.file, rule, section.resolution),
                     environment.values);
}

std::string LabelOf(const Activity& activity) {
  if (!activity.is_active) return "inactive";
  if (activity.count == 1) return "active";
  return fmt::format("active, joined {} of {}", activity.number,
                     activity.count);
}

class Hinter {
 public:
  Hinter(const Analysis& analysis, const Section& section,
         NamedEnvironment environment)
      : analysis_(analysis),
        section_(section),
        environment_(std::move(environment)),
        values_(Printable(PrintEnvironment(environment_.environment,
                                           section.scope.header.states),
                          kMaxShown)) {
    const ast::File& file = section.file;
    for (const ast::Rule& rule : file.rules) {
      const auto holds = Holds(section, rule, environment_.environment);
      Activity activity;
      activity.is_active = holds.value_or(false);
      if (activity.is_active) activity.number = ++active_[file.Text(rule.head)];
      known_.push_back(holds.has_value());
      activities_.push_back(activity);
    }
  }

  // Appends the hints of the section's rules in `span` whose lines have none.
  void AddTo(Span span, std::set<std::uint32_t>* taken, Json* hints) {
    const ast::File& file = section_.file;
    for (std::size_t i = 0; i < file.rules.size(); ++i) {
      const ast::Rule& rule = file.rules[i];
      Activity activity = activities_[i];
      activity.count = active_[file.Text(rule.head)];
      const bool says_something = rule.terms.count > 0 || activity.count > 1;
      if (!known_[i] || !says_something) continue;
      const std::uint32_t anchor =
          rule.terms.count > 0 ? rule.clause.end : rule.head.end;
      const std::uint32_t at = analysis_.lines().LineEnd(anchor);
      if (at < span.begin || anchor > span.end || !taken->insert(at).second)
        continue;
      hints->push_back(HintJson(at, activity, file.Text(rule.head)));
    }
  }

 private:
  Json HintJson(std::uint32_t at, const Activity& activity,
                std::string_view head) const {
    std::string tooltip = fmt::format("in {}", environment_.name);
    if (values_ != environment_.name && !values_.empty())
      tooltip += fmt::format(" ({})", values_);
    tooltip += fmt::format(": {} of the rules of {} {} active", activity.count,
                           head, activity.count == 1 ? "is" : "are");
    return {{"position", PlaceJson(analysis_.lines().PlaceAt(at))},
            {"label", LabelOf(activity)},
            {"tooltip", tooltip},
            {"paddingLeft", true}};
  }

  const Analysis& analysis_;
  const Section& section_;
  NamedEnvironment environment_;
  std::string values_;  // of the environment; every hint says them
  std::vector<Activity> activities_;        // by rule
  std::vector<bool> known_;                 // by rule
  std::map<std::string_view, int> active_;  // rules, by head
};

}  // namespace

Json InlayHints(Analysis& analysis, Span span, const std::string& environment) {
  Json hints = Json::array();
  // Rules that genotypes share are shown as the first of them has them.
  std::set<std::uint32_t> taken;
  for (const Section& section : analysis.sections()) {
    auto chosen = ChosenFor(section, environment);
    if (!chosen) continue;
    Hinter(analysis, section, *std::move(chosen)).AddTo(span, &taken, &hints);
  }
  return hints;
}

}  // namespace plsc::lsp
