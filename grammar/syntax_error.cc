// A failure of the parser is the name of what was required (messages.h) and a
// place. What people need is what they did instead, and that is guessed from
// the text around the place: a table of functions, one a requirement, each
// going from the particular to the general. What another language would write
// there comes first (foreign_syntax, number_error, clause_error), then a
// misspelling, and at last "expected X, found Y". Guesses only choose words and
// fixes; whether there is an error has been decided.

#include "grammar/syntax_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "grammar/clause_error.h"
#include "grammar/foreign_syntax.h"
#include "grammar/keywords.h"
#include "grammar/lookaround.h"
#include "grammar/number_error.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

std::string_view ItemWord(const SyntaxContext& context) {
  return context.text.substr(context.item.begin,
                             context.item.end - context.item.begin);
}

// "expected X, found Y": what most failures come down to.
Diagnostic Expected(const SyntaxContext& context, const char* code,
                    std::string_view what, std::string label = "") {
  Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.span = CaretOf(context);
  const Found found = FoundAt(context.text, context.offset);
  diagnostic.message = fmt::format("expected {}, found {}", what, found.quoted);
  diagnostic.label = std::move(label);
  return diagnostic;
}

Diagnostic VersionWord(const SyntaxContext& context) {
  Diagnostic diagnostic;
  diagnostic.code = "P5001";
  diagnostic.message = "a genotype file starts with the language version";
  const Found found = FoundAt(context.text, context.offset);
  diagnostic.span = found.span;
  static constexpr std::string_view kWord = "plsc";
  if (Suggest(found.text, {&kWord, 1})) {
    diagnostic.label = "did you mean 'plsc'?";
    diagnostic.fixes.push_back({found.span, "plsc"});
    return diagnostic;
  }
  diagnostic.label = "expected 'plsc 1' before this";
  diagnostic.help = "add 'plsc 1' as the first line";
  diagnostic.fixes.push_back(
      {{found.span.begin, found.span.begin}, "plsc 1\n"});
  return diagnostic;
}

// "1.5", "v1", "-1": something that its author took for a version.
bool IsVersionLike(std::string_view word) {
  return std::any_of(word.begin(), word.end(),
                     [](char c) { return c >= '0' && c <= '9'; }) &&
         std::all_of(word.begin(), word.end(), [](char c) {
           return IsWordCharacter(c) || c == '.' || c == '-' || c == '+';
         });
}

Diagnostic VersionNumber(const SyntaxContext& context) {
  Diagnostic diagnostic = Expected(
      context, "P5001", "the language version after 'plsc'", "write 'plsc 1'");
  const std::size_t begin =
      context.text.find_first_not_of(" \t", context.previous_end);
  if (begin == std::string_view::npos) return diagnostic;
  const std::string_view word = context.text.substr(
      begin, context.text.find_first_of(" \t\r\n#", begin) - begin);
  // Longer than any version is something else.
  constexpr std::size_t kMaxVersion = 20;
  if (word.size() > kMaxVersion || !IsVersionLike(word)) return diagnostic;
  diagnostic.span = {static_cast<std::uint32_t>(begin),
                     static_cast<std::uint32_t>(begin + word.size())};
  diagnostic.message =
      fmt::format("the language version is a whole number, found '{}'", word);
  if (word.starts_with("1.") || word == "v1")
    diagnostic.fixes.push_back({diagnostic.span, "1"});
  return diagnostic;
}

Diagnostic UnknownItem(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic;
  diagnostic.code = "P1101";
  diagnostic.span = found.span;
  if (found.text == "plsc") {
    diagnostic.message = "'plsc' may stand only once, at the top";
    diagnostic.label = "remove this";
    return diagnostic;
  }
  if (found.text == "include") {
    diagnostic.message = "'include' is reserved and has no meaning in plsc 1";
    return diagnostic;
  }
  if (!IsWordCharacter(found.text.empty() ? ' ' : found.text[0])) {
    diagnostic.message =
        fmt::format("expected an item, found {}", found.quoted);
    if (found.text == "}") diagnostic.label = "nothing is open here";
    return diagnostic;
  }
  diagnostic.message = fmt::format("unknown item {}", found.quoted);
  const std::size_t next =
      context.text.find_first_not_of(" \t", found.span.end);
  if (next != std::string_view::npos &&
      context.text.substr(next).starts_with("->")) {
    diagnostic.label = fmt::format("write 'rule {} -> ...'", found.text);
    diagnostic.fixes.push_back({{found.span.begin, found.span.begin}, "rule "});
  } else if (const auto near = Suggest(found.text, ItemKeywords())) {
    diagnostic.label = fmt::format("did you mean '{}'?", *near);
    diagnostic.fixes.push_back({found.span, *near});
  } else {
    diagnostic.help =
        fmt::format("items start with {}", fmt::join(ItemKeywords(), ", "));
  }
  return diagnostic;
}

Diagnostic MissingName(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  const Found before = FoundBefore(context.text, context.previous_end);
  const std::string what = fmt::format("a name after {}", before.quoted);
  Diagnostic diagnostic = Expected(context, "P1102", what);
  if (IsKeyword(found.text)) diagnostic.label = "this word is reserved";
  return diagnostic;
}

Diagnostic MissingMark(const SyntaxContext& context, std::string_view mark) {
  const Found found = FoundAt(context.text, context.offset);
  const Found before = FoundBefore(context.text, context.previous_end);
  Diagnostic diagnostic = Expected(
      context, "P1115", fmt::format("'{}' after {}", mark, before.quoted));
  const bool is_mark =
      found.text.find_first_not_of("=<>:-~") == std::string_view::npos;
  if (is_mark && !found.is_end) {
    diagnostic.label = fmt::format("write '{}'", mark);
    diagnostic.fixes.push_back({found.span, std::string(mark)});
  }
  return diagnostic;
}

// `thing` was opened at context.open and runs into the next item or the end.
Diagnostic Unclosed(const SyntaxContext& context, std::string_view thing) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic;
  diagnostic.code = "P1107";
  diagnostic.span = context.open;
  diagnostic.message = fmt::format("this {} is never closed", thing);
  diagnostic.label = "opened here";
  diagnostic.others.push_back(
      {found.span,
       found.is_end
           ? std::string("the file ends here; insert '}' before")
           : std::string("the next item starts here; insert '}' before")});
  diagnostic.fixes.push_back(
      {{context.previous_end, context.previous_end}, "\n}"});
  return diagnostic;
}

Diagnostic InBraces(const SyntaxContext& context, std::string_view thing,
                    std::string_view what) {
  const Found found = FoundAt(context.text, context.offset);
  if (IsItemOrEnd(found)) return Unclosed(context, thing);
  Diagnostic diagnostic = Expected(context, "P1116", what);
  if (thing == "production" && (found.text == "," || found.text == ";")) {
    diagnostic.label = "symbols are separated by blanks";
    diagnostic.fixes.push_back({found.span, ""});
  } else if (IsKeyword(found.text)) {
    diagnostic.label = "this word is reserved";
  }
  return diagnostic;
}

Diagnostic FirstSymbol(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  if (found.text != "}") return InBraces(context, "production", "a symbol");
  Diagnostic diagnostic;
  diagnostic.code = "P1113";
  diagnostic.span = {context.open.begin, found.span.end};
  diagnostic.message = "a production has at least one symbol";
  diagnostic.label = "nothing to rewrite into";
  diagnostic.notes.emplace_back(
      "a symbol for which no rule is active stays as it is");
  return diagnostic;
}

Diagnostic BodyDepth(const SyntaxContext& context) {
  Diagnostic diagnostic;
  diagnostic.code = "P3002";
  diagnostic.span = CaretOf(context);
  diagnostic.message = "an expected body is nested too deeply";
  diagnostic.label = "no robot of a scenario has limbs that long";
  return diagnostic;
}

Diagnostic OfBody(SyntaxError error, const SyntaxContext& context) {
  switch (error) {
    case SyntaxError::kModule: {
      const Found before = FoundBefore(context.text, context.previous_end);
      return Expected(context, "P1116",
                      fmt::format("a module after {}", before.quoted),
                      before.text == "body" ? "a body starts with the core, C"
                                            : "write 'FACE MODULE'");
    }
    case SyntaxError::kBodyEnd:
      return InBraces(context, "module", "'FACE MODULE' or '}'");
    default:
      return BodyDepth(context);
  }
}

Diagnostic OpenBrace(const SyntaxContext& context) {
  const Found before = FoundBefore(context.text, context.previous_end);
  const bool is_test = ItemWord(context) == "test";
  if (before.text == "->")
    return Expected(
        context, "P1115",
        is_test ? "'{' or 'body' after '->'" : "'if' or '{' after '->'",
        is_test ? "the expected string stands in braces"
                : "a production stands in braces");
  return MissingMark(context, "{");
}

Diagnostic MissingNumber(const SyntaxContext& context, const char* code,
                         std::string_view what) {
  if (auto number = DescribeNumberLike(context)) return *std::move(number);
  const Found before = FoundBefore(context.text, context.previous_end);
  return Expected(context, code,
                  fmt::format("{} after {}", what, before.quoted));
}

Diagnostic Argument(const SyntaxContext& context) {
  Diagnostic diagnostic = MissingNumber(context, "P1108", "a number");
  if (context.text.substr(0, context.previous_end).ends_with('(') &&
      context.text.substr(context.offset).starts_with(')'))
    diagnostic.help =
        "a symbol without arguments is written without parentheses";
  return diagnostic;
}

Diagnostic SettingValue(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic = MissingNumber(context, "P1108", "a value");
  if (found.text == "=" || found.text == ":") {
    diagnostic.label = fmt::format("write '{} VALUE'", ItemWord(context));
    diagnostic.fixes.push_back({found.span, ""});
  }
  return diagnostic;
}

Diagnostic OfClause(SyntaxError error, const SyntaxContext& context) {
  if (auto foreign = DescribeForeign(error, context))
    return *std::move(foreign);
  const Found before = FoundBefore(context.text, context.previous_end);
  switch (error) {
    case SyntaxError::kTerm:
      return Expected(context, "P1105",
                      fmt::format("a term after {}", before.quoted),
                      "expected 'STATE = VALUE' here");
    case SyntaxError::kComparison:
      return DescribeMissingComparison(context);
    case SyntaxError::kThen:
      return DescribeMissingThen(context);
    default:
      return MissingNumber(context, "P1108", "a value");
  }
}

Diagnostic OfType(SyntaxError error, const SyntaxContext& context) {
  switch (error) {
    case SyntaxError::kStateType:
      return Expected(context, "P1117", "a type",
                      "write 'bool', 'real in LOW..HIGH' or '{ NAME, NAME }'");
    case SyntaxError::kParameterType:
      return Expected(context, "P1117", "'real' or 'int'");
    case SyntaxError::kIn:
      return Expected(context, "P1115", "'in' after 'real'",
                      "a real state has a range, as in 'real in -40..60'");
    case SyntaxError::kDots: {
      Diagnostic diagnostic = MissingMark(context, "..");
      diagnostic.label = "a range is written LOW..HIGH";
      return diagnostic;
    }
    case SyntaxError::kEnumEnd:
      return InBraces(context, "list of values", "',' or '}'");
    default:
      return Expected(context, "P1118", "a version or '{'",
                      "write 'alphabet plasticoding 1'");
  }
}

Diagnostic OfAlphabet(SyntaxError error, const SyntaxContext& context) {
  return InBraces(context, "alphabet",
                  error == SyntaxError::kGroup
                      ? "'replaceable' or 'terminal'"
                      : "',', 'replaceable', 'terminal' or '}'");
}

Diagnostic OfMark(SyntaxError error, const SyntaxContext& context) {
  switch (error) {
    case SyntaxError::kArrow:
      return MissingMark(context, "->");
    case SyntaxError::kEquals:
      return MissingMark(context, "=");
    case SyntaxError::kColon:
      return MissingMark(context, ":");
    case SyntaxError::kOpenBrace:
      return OpenBrace(context);
    default:
      return Expected(context, "P1109", "',' or ')'");
  }
}

Diagnostic OfNumber(SyntaxError error, const SyntaxContext& context) {
  switch (error) {
    case SyntaxError::kArgument:
      return Argument(context);
    case SyntaxError::kDigits:
      return DescribeMissingDigits(context);
    case SyntaxError::kNumberEnd:
      return DescribeNumberEnd(context);
    case SyntaxError::kSettingValue:
      return SettingValue(context);
    case SyntaxError::kNumber:
      return MissingNumber(context, "P1108", "a number");
    default:
      return MissingNumber(context, "P1108", "a value");
  }
}

Diagnostic Describe(SyntaxError error, const SyntaxContext& context) {
  using enum SyntaxError;
  switch (error) {
    case kInternal:
      return Expected(context, "P1199", "something else (a defect of plsc)");
    case kVersionWord:
      return VersionWord(context);
    case kVersionNumber:
      return VersionNumber(context);
    case kItem:
      return UnknownItem(context);
    case kName:
    case kEnumValue:
      return MissingName(context);
    case kArrow:
    case kOpenBrace:
    case kCloseParen:
    case kParametersEnd:
    case kEquals:
    case kColon:
      return OfMark(error, context);
    case kFirstSymbol:
      return FirstSymbol(context);
    case kProductionEnd:
      return InBraces(context, "production", "a symbol or '}'");
    case kTerm:
    case kComparison:
    case kTermValue:
    case kThen:
      return OfClause(error, context);
    case kArgument:
    case kDigits:
    case kNumberEnd:
    case kNumber:
    case kSettingValue:
    case kEntryValue:
      return OfNumber(error, context);
    case kStateType:
    case kIn:
    case kDots:
    case kEnumEnd:
    case kAlphabetBody:
    case kParameterType:
      return OfType(error, context);
    case kGroup:
    case kAlphabetEnd:
      return OfAlphabet(error, context);
    case kEnvironmentEnd:
      return InBraces(context, "environment", "'STATE = VALUE' or '}'");
    case kModule:
    case kBodyEnd:
    case kBodyDepth:
      return OfBody(error, context);
  }
  return {};
}

}  // namespace

Diagnostic DescribeSyntaxError(SyntaxError error,
                               const SyntaxContext& context) {
  Diagnostic diagnostic = Describe(error, context);
  ExplainForeignSyntax(error, context, &diagnostic);
  return diagnostic;
}

}  // namespace plsc
