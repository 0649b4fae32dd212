#include "grammar/clause_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "grammar/lookaround.h"
#include "grammar/utf8.h"

namespace plsc {

namespace {

Diagnostic Make(const char* code, Span span, std::string message,
                std::string label) {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.span = span;
  diagnostic.message = std::move(message);
  diagnostic.label = std::move(label);
  return diagnostic;
}

// Characters from the start of the line, as users count columns.
int ColumnOf(std::string_view text, std::uint32_t offset) {
  const std::string_view before = text.substr(0, offset);
  // Without a line break npos + 1 is 0.
  return static_cast<int>(
             CountCharacters(before.substr(before.rfind('\n') + 1))) +
         1;
}

// The rest of the clause on the same line may have more of it; telling all at
// once saves as many runs.
void AddOtherForeignWords(const SyntaxContext& context, std::uint32_t from,
                          Diagnostic* diagnostic) {
  const std::size_t stop =
      std::min(context.text.find_first_of("{\n#", from), context.text.size());
  std::vector<std::string> others;
  for (std::uint32_t at = from; at < stop;) {
    const Found found = FoundAt(context.text, at);
    const std::string_view right = PlscWordFor(found.text);
    if (!right.empty() && found.span.begin >= from) {
      others.push_back(fmt::format("'{}' -> '{}' (column {})", found.text,
                                   right,
                                   ColumnOf(context.text, found.span.begin)));
      diagnostic->fixes.push_back({found.span, std::string(right)});
    }
    at = std::max(found.span.end, at + 1);
  }
  if (!others.empty())
    diagnostic->notes.push_back(
        fmt::format("also {}", fmt::join(others, ", ")));
}

Diagnostic ForeignOperator(const SyntaxContext& context, Found found,
                           std::string_view right) {
  Diagnostic diagnostic =
      Make("P1104", found.span,
           fmt::format("{} is not a plsc operator", found.quoted),
           fmt::format("use '{}'", right));
  diagnostic.fixes.push_back({found.span, std::string(right)});
  AddOtherForeignWords(context, found.span.end, &diagnostic);
  return diagnostic;
}

}  // namespace

std::optional<Diagnostic> DescribeForeign(SyntaxError error,
                                          const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  if (found.text == "(" || found.text == ")") {
    Diagnostic diagnostic =
        Make("P1114", found.span, "clauses of plsc 1 have no parentheses",
             "remove this");
    diagnostic.notes.emplace_back("'and' binds tighter than 'or'");
    return diagnostic;
  }
  if (error == SyntaxError::kTerm &&
      (found.text == "not" || found.text.starts_with('!')))
    return Make("P1104", found.span,
                fmt::format("{} is not a plsc operator", found.quoted),
                "write 'STATE = False'");
  // The grammar may have taken the first half of '<>', '=<' or '=>'.
  Found whole = found;
  if (error == SyntaxError::kTermValue &&
      context.previous_end == context.offset)
    whole = FoundAt(context.text,
                    FoundBefore(context.text, context.offset).span.begin);
  const std::string_view right = PlscWordFor(whole.text);
  const bool is_value = right == "True" || right == "False";
  if (right.empty() || is_value) return std::nullopt;
  return ForeignOperator(context, whole, right);
}

Diagnostic DescribeMissingComparison(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  const Found state = FoundBefore(context.text, context.previous_end);
  Diagnostic diagnostic =
      Make("P1103", CaretOf(context),
           fmt::format("expected a comparison after state {}", state.quoted),
           "expected '=', '!=', '<', '<=', '>' or '>='");
  const Span after = {context.previous_end, context.previous_end};
  if (found.text == "then" || found.text == "and" || found.text == "or" ||
      found.text == "{") {
    diagnostic.help = fmt::format("write '{} = True'", state.text);
    diagnostic.fixes.push_back({after, " = True"});
  } else if (found.text == "True" || found.text == "False") {
    diagnostic.help = fmt::format("write '{} = {}'", state.text, found.text);
    diagnostic.fixes.push_back({after, " ="});
  }
  return diagnostic;
}

Diagnostic DescribeMissingThen(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic = Make(
      "P1106", CaretOf(context),
      fmt::format("expected 'and', 'or' or 'then', found {}", found.quoted),
      "");
  if (found.text == "{") {
    diagnostic.label = "insert 'then' before this";
    diagnostic.fixes.push_back({{found.span.begin, found.span.begin}, "then "});
  }
  return diagnostic;
}

}  // namespace plsc
