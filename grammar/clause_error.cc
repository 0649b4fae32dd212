#include "grammar/clause_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "grammar/lookaround.h"
#include "grammar/utf8.h"

namespace plsc {

namespace {

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
      diagnostic->WithFix(found.span, std::string(right));
    }
    at = std::max(found.span.end, at + 1);
  }
  if (!others.empty())
    diagnostic->WithNote(fmt::format("also {}", fmt::join(others, ", ")));
}

Diagnostic ForeignOperator(const SyntaxContext& context, Found found,
                           std::string_view right) {
  Diagnostic diagnostic(Code::kForeignNotation, found.span,
                        fmt::format("{} is not a plsc operator", found.quoted));
  diagnostic.WithLabel(fmt::format("use '{}'", right))
      .WithFix(found.span, std::string(right));
  AddOtherForeignWords(context, found.span.end, &diagnostic);
  return diagnostic;
}

}  // namespace

std::optional<Diagnostic> DescribeForeign(SyntaxError error,
                                          const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  if (found.text == "(" || found.text == ")")
    return Diagnostic(Code::kParentheses, found.span,
                      "clauses of plsc 1 have no parentheses")
        .WithLabel("remove this")
        .WithNote("'and' binds tighter than 'or'");
  if (error == SyntaxError::kTerm &&
      (found.text == "not" || found.text.starts_with('!')))
    return Diagnostic(Code::kForeignNotation, found.span,
                      fmt::format("{} is not a plsc operator", found.quoted))
        .WithLabel("write 'STATE = False'");
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
  Diagnostic diagnostic(
      Code::kMissingComparison, CaretOf(context),
      fmt::format("expected a comparison after state {}", state.quoted));
  diagnostic.label = "expected '=', '!=', '<', '<=', '>' or '>='";
  const Span after = {context.previous_end, context.previous_end};
  if (found.text == "then" || found.text == "and" || found.text == "or" ||
      found.text == "{") {
    diagnostic.WithHelp(fmt::format("write '{} = True'", state.text))
        .WithFix(after, " = True");
  } else if (found.text == "True" || found.text == "False") {
    diagnostic.WithHelp(fmt::format("write '{} = {}'", state.text, found.text))
        .WithFix(after, " =");
  }
  return diagnostic;
}

Diagnostic DescribeMissingThen(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic(
      Code::kMissingThen, CaretOf(context),
      fmt::format("expected 'and', 'or' or 'then', found {}", found.quoted));
  if (found.text == "{")
    diagnostic.WithLabel("insert 'then' before this")
        .WithFix({found.span.begin, found.span.begin}, "then ");
  return diagnostic;
}

}  // namespace plsc
