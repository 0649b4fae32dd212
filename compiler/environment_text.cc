#include "compiler/environment_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "grammar/number.h"
#include "grammar/reporter.h"

namespace plsc {

namespace {

struct Assignment {
  Span name;
  Span value;
};

std::string_view At(const Source& source, Span span) {
  return source.text().substr(span.begin, span.end - span.begin);
}

bool IsBlank(char c) {
  return c == ' ' || c == '\t';
}

Span Trim(const Source& source, Span span) {
  const std::string_view text = source.text();
  while (span.begin < span.end && IsBlank(text[span.begin])) ++span.begin;
  while (span.end > span.begin && IsBlank(text[span.end - 1])) --span.end;
  return span;
}

// "a=1, b = 2" into its parts; an empty text has none.
Result<std::vector<Assignment>> Split(const Source& source) {
  std::vector<Assignment> assignments;
  const std::string_view text = source.text();
  const auto size = static_cast<std::uint32_t>(text.size());
  if (Trim(source, {0, size}).begin == size) return assignments;
  for (std::uint32_t begin = 0; begin <= size;) {
    const auto comma = static_cast<std::uint32_t>(
        std::min(text.find(',', begin), text.size()));
    const Span part = Trim(source, {begin, comma});
    const std::size_t equals = At(source, part).find('=');
    if (equals == std::string_view::npos)
      return Diagnostic(Code::kMissingMark, part, "expected STATE=VALUE")
          .WithHelp("write an environment as inclined=True,hot=False");
    const auto middle = part.begin + static_cast<std::uint32_t>(equals);
    assignments.push_back({Trim(source, {part.begin, middle}),
                           Trim(source, {middle + 1, part.end})});
    begin = comma + 1;
  }
  return assignments;
}

// A number is out of range; anything else is of another type.
Diagnostic WrongValue(const Source& source, Span span, const State& state) {
  const bool is_number = state.type == StateType::kReal &&
                         ParseNumber<double>(At(source, span)).has_value();
  return {is_number ? Code::kWrongEnvironment : Code::kValueType, span,
          fmt::format("expected {} for state '{}', found '{}'",
                      ExpectedValue(state), state.name, At(source, span))};
}

Diagnostic Missing(const Source& source, const State& state) {
  const auto end = static_cast<std::uint32_t>(source.text().size());
  const char* example = state.type == StateType::kBool ? "True"
                        : state.type == StateType::kEnum
                            ? state.values.front().c_str()
                            : "0.5";
  return Diagnostic(Code::kWrongEnvironment, {end, end},
                    fmt::format("no value for state '{}'", state.name))
      .WithHelp(fmt::format("every state that the genotype senses needs a "
                            "value: add {}={}",
                            state.name, example));
}

}  // namespace

std::optional<double> ParseStateValue(std::string_view text,
                                      const State& state) {
  switch (state.type) {
    case StateType::kBool:
      if (text == "True") return 1;
      if (text == "False") return 0;
      return std::nullopt;
    case StateType::kEnum: {
      const auto found =
          std::find(state.values.begin(), state.values.end(), text);
      if (found == state.values.end()) return std::nullopt;
      return static_cast<double>(found - state.values.begin());
    }
    case StateType::kReal: {
      const std::optional<double> value = ParseNumber<double>(text);
      if (!value || *value < state.low || *value > state.high)
        return std::nullopt;
      return value;
    }
  }
  return std::nullopt;
}

std::string ExpectedValue(const State& state) {
  switch (state.type) {
    case StateType::kBool:
      return "True or False";
    case StateType::kReal:
      return fmt::format("a number in {}..{}", state.low, state.high);
    case StateType::kEnum:
      return fmt::format("one of {}", fmt::join(state.values, ", "));
  }
  return "";
}

Result<Environment> ParseEnvironment(const Source& source,
                                     const std::vector<State>& states) {
  const Result<std::vector<Assignment>> assignments = Split(source);
  if (!assignments) return assignments.diagnostics();

  Reporter errors;
  Reporter warnings;
  std::vector<std::optional<double>> values(states.size());
  std::map<std::string_view, Span> seen;
  for (const auto& [name_span, value_span] : *assignments) {
    const std::string_view name = At(source, name_span);
    if (!seen.emplace(name, name_span).second) {
      errors.Report(Code::kWrongEnvironment, name_span,
                    fmt::format("state '{}' is given twice", name));
      continue;
    }
    const auto state =
        std::find_if(states.begin(), states.end(),
                     [&](const State& s) { return s.name == name; });
    if (state == states.end()) {
      warnings.Report(
          Code::kUnsensedState, name_span,
          fmt::format("the genotype does not sense '{}'; ignored", name));
      continue;
    }
    auto& value = values[static_cast<std::size_t>(state - states.begin())];
    value = ParseStateValue(At(source, value_span), *state);
    if (!value) errors.Add(WrongValue(source, value_span, *state));
  }

  Environment environment;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!seen.contains(states[i].name)) errors.Add(Missing(source, states[i]));
    environment.values.push_back(values[i].value_or(0));
  }
  if (!errors.has_errors()) return {std::move(environment), warnings.Take()};
  std::vector<Diagnostic> all = errors.Take();
  for (Diagnostic& warning : warnings.Take()) all.push_back(std::move(warning));
  return all;
}

}  // namespace plsc
