// A walk over the trees of all sections. What stands before the first genotype
// of several is in the tree of each, so that a number is kept once, by its
// place. A constant has the bounds of all that it is used for.

#include "runtime/service/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "compiler/limits.h"
#include "runtime/lsp/descriptions.h"
#include "runtime/lsp/keyword_docs.h"

namespace plsc::service {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Bounds {
  double lowest = -kInfinity;
  double highest = kInfinity;
  bool is_whole = false;

  void Narrow(const Bounds& other) {
    lowest = std::max(lowest, other.lowest);
    highest = std::min(highest, other.highest);
    is_whole |= other.is_whole;
  }
};

Bounds BoundsOf(ast::SettingKey key) {
  switch (key) {
    case ast::SettingKey::kIterations:
      return {kMinIterations, kMaxIterations, true};
    case ast::SettingKey::kMaxModules:
      return {kMinModules, kMaxModules, true};
    case ast::SettingKey::kMoveToNew:
      break;
    case ast::SettingKey::kMaxTerms:
    case ast::SettingKey::kMaxRules:
      return {kMinLimit, kMaxLimit, true};
  }
  return {};
}

/// What a value is for.
struct Use {
  const char* kind;
  std::string name;
  std::string about;
  Bounds bounds;
};

/// By position, of all sections.
using Numbers = std::map<std::uint32_t, TurnableNumber>;

class Collector {
 public:
  Collector(const lsp::Section& section, Numbers* numbers)
      : section_(section), file_(section.file), numbers_(*numbers) {}

  void Collect() {
    for (const ast::Rule& rule : file_.rules) {
      for (std::uint32_t k = 0; k < rule.terms.count; ++k)
        AddTerm(rule.terms.first + k);
      for (std::uint32_t k = 0; k < rule.symbols.count; ++k)
        AddSymbol(rule.symbols.first + k);
    }
    for (std::size_t i = 0; i < file_.entries.size(); ++i)
      if (const ResolvedTerm& entry = section_.resolution.entries[i])
        AddSensed("sensed", file_.entries[i].span, file_.entries[i].value,
                  *entry);
    for (const ast::Item& item : file_.items) AddItem(item);
  }

 private:
  void AddTerm(std::uint32_t at) {
    if (const ResolvedTerm& term = section_.resolution.terms[at])
      AddSensed("threshold", file_.terms[at].span, file_.terms[at].value,
                *term);
  }

  void AddSensed(const char* kind, Span around, const ast::Value& value,
                 const Term& term) {
    const State& state = section_.scope.header.StateOf(term.state);
    if (state.type != StateType::kReal) return;
    Add(around, value,
        {kind,
         state.name,
         lsp::DescribeState(state),
         {state.low, state.high, false}});
  }

  void AddSymbol(std::uint32_t at) {
    const ast::Symbol& symbol = file_.symbols[at];
    const auto& id = section_.resolution.symbols[at];
    if (!id) return;
    const SymbolInfo& info = section_.scope.header.SymbolOf(*id);
    const auto arguments = Slice(file_.arguments, symbol.arguments);
    const std::size_t count =
        std::min(arguments.size(), info.parameters.size());
    for (std::size_t k = 0; k < count; ++k) {
      const Parameter& parameter = info.parameters[k];
      Add(symbol.span, arguments[k],
          {"argument",
           fmt::format("{} of {}", parameter.name, info.name),
           fmt::format("{} of `{}`\n", lsp::DescribeParameter(parameter),
                       info.name),
           {parameter.low, parameter.high, parameter.is_integer}});
    }
  }

  // Constants come before their uses in a text, but items are looked at last.
  void AddItem(const ast::Item& item) {
    const std::string word(file_.Text(item.keyword));
    if (item.kind == ast::ItemKind::kSetting) {
      const ast::Setting& setting = file_.settings[item.index];
      Add(item.span, setting.value,
          {"setting", word, std::string(lsp::KeywordDoc(word)),
           BoundsOf(setting.key)});
    } else if (item.kind == ast::ItemKind::kLet) {
      const ast::Let& let = file_.lets[item.index];
      const std::string name(file_.Text(let.name));
      Add(item.span, let.value,
          {"constant", name,
           fmt::format("```pls\n{}\n```\n", file_.Text(item.span)),
           constants_[name]});
    }
  }

  void Add(Span around, const ast::Value& value, Use use) {
    const Bounds& bounds = use.bounds;
    if (value.kind == ast::Value::Kind::kName)
      constants_[std::string(file_.Text(value.span))].Narrow(bounds);
    if (value.kind != ast::Value::Kind::kNumber) return;
    TurnableNumber number{value.span,
                          around,
                          use.kind,
                          std::move(use.name),
                          std::move(use.about),
                          value.number,
                          bounds.is_whole,
                          bounds.lowest,
                          bounds.highest};
    const auto [kept, is_new] =
        numbers_.emplace(value.span.begin, std::move(number));
    if (is_new) return;
    // A constant that several genotypes use.
    Bounds both{kept->second.lowest, kept->second.highest,
                kept->second.is_whole};
    both.Narrow(bounds);
    kept->second.lowest = both.lowest;
    kept->second.highest = both.highest;
    kept->second.is_whole = both.is_whole;
  }

  const lsp::Section& section_;
  const ast::File& file_;
  Numbers& numbers_;
  std::map<std::string, Bounds> constants_;  ///< of their uses
};

std::uint32_t Distance(Span span, std::uint32_t offset) {
  if (offset < span.begin) return span.begin - offset;
  return offset > span.end ? offset - span.end : 0;
}

bool Touches(Span span, std::uint32_t offset) {
  return Distance(span, offset) == 0;
}

/// 1, 2 or 5 times a power of ten, the one nearest to `step`.
double NearestRound(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  double best = power;
  for (const double factor : {2.0, 5.0, 10.0})
    if (std::abs(std::log(factor * power / step)) <
        std::abs(std::log(best / step)))
      best = factor * power;
  return best;
}

}  // namespace

std::vector<TurnableNumber> NumbersOf(lsp::Analysis& analysis) {
  Numbers numbers;
  for (const lsp::Section& section : analysis.sections())
    Collector(section, &numbers).Collect();
  std::vector<TurnableNumber> all;
  for (auto& [begin, number] : numbers) all.push_back(std::move(number));
  return all;
}

std::optional<TurnableNumber> NumberAt(
    lsp::Analysis& analysis, const std::vector<TurnableNumber>& numbers,
    std::uint32_t offset) {
  const lsp::Mention* mention = analysis.MentionAt(offset);
  if (mention != nullptr && mention->kind == lsp::NameKind::kConstant) {
    for (const TurnableNumber& number : numbers)
      if (number.kind == "constant" &&
          Touches(number.around, mention->declaration.begin))
        return number;
  }
  const TurnableNumber* nearest = nullptr;
  for (const TurnableNumber& number : numbers) {
    if (!Touches(number.around, offset)) continue;
    if (nearest == nullptr ||
        Distance(number.span, offset) < Distance(nearest->span, offset))
      nearest = &number;
  }
  return nearest == nullptr ? std::nullopt : std::optional(*nearest);
}

SliderRange SliderOf(const TurnableNumber& number) {
  // Where there is no bound: four times the deviation of what evolution draws,
  // and room on both sides of what is written.
  const double reach = std::min(
      std::max(number.is_whole ? 8.0 : 4.0, 2 * std::abs(number.value)),
      kMaxWholeNumber);
  SliderRange range;
  range.from = std::isinf(number.lowest) ? -reach : number.lowest;
  range.to = std::isinf(number.highest) ? std::max(range.from + 1, reach)
                                        : number.highest;
  range.from = std::min(range.from, range.to);
  range.step = 1;
  if (!number.is_whole && range.to > range.from)
    range.step = NearestRound((range.to - range.from) / 100);
  return range;
}

}  // namespace plsc::service
