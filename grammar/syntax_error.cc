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
Diagnostic Expected(const SyntaxContext& context, Code code,
                    std::string_view what, std::string label = "") {
  const Found found = FoundAt(context.text, context.offset);
  return Diagnostic(code, CaretOf(context),
                    fmt::format("expected {}, found {}", what, found.quoted))
      .WithLabel(std::move(label));
}

Diagnostic VersionWord(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic(Code::kMissingVersion, found.span,
                        "a genotype file starts with the language version");
  static constexpr std::string_view kWord = "plsc";
  if (AddSuggestion(found.text, {&kWord, 1}, &diagnostic)) return diagnostic;
  return diagnostic.WithLabel("expected 'plsc 1' before this")
      .WithHelp("add 'plsc 1' as the first line")
      .WithFix({found.span.begin, found.span.begin}, "plsc 1\n");
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
  Diagnostic diagnostic =
      Expected(context, Code::kMissingVersion,
               "the language version after 'plsc'", "write 'plsc 1'");
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
  const auto report = [&](std::string message) {
    return Diagnostic(Code::kUnknownItem, found.span, std::move(message));
  };
  if (found.text == "plsc")
    return report("'plsc' may stand only once, at the top")
        .WithLabel("remove this");
  if (found.text == "include")
    return report("'include' is reserved and has no meaning in plsc 1");
  if (!IsWordCharacter(found.text.empty() ? ' ' : found.text[0]))
    return report(fmt::format("expected an item, found {}", found.quoted))
        .WithLabel(found.text == "}" ? "nothing is open here" : "");
  Diagnostic diagnostic = report(fmt::format("unknown item {}", found.quoted));
  const std::size_t next =
      context.text.find_first_not_of(" \t", found.span.end);
  if (next != std::string_view::npos &&
      context.text.substr(next).starts_with("->")) {
    diagnostic.WithLabel(fmt::format("write 'rule {} -> ...'", found.text))
        .WithFix({found.span.begin, found.span.begin}, "rule ");
  } else if (!AddSuggestion(found.text, ItemKeywords(), &diagnostic)) {
    diagnostic.help =
        fmt::format("items start with {}", fmt::join(ItemKeywords(), ", "));
  }
  return diagnostic;
}

Diagnostic MissingName(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  const Found before = FoundBefore(context.text, context.previous_end);
  const std::string what = fmt::format("a name after {}", before.quoted);
  Diagnostic diagnostic = Expected(context, Code::kMissingName, what);
  if (IsKeyword(found.text)) diagnostic.label = "this word is reserved";
  return diagnostic;
}

Diagnostic MissingMark(const SyntaxContext& context, std::string_view mark) {
  const Found found = FoundAt(context.text, context.offset);
  const Found before = FoundBefore(context.text, context.previous_end);
  Diagnostic diagnostic =
      Expected(context, Code::kMissingMark,
               fmt::format("'{}' after {}", mark, before.quoted));
  const bool is_mark =
      found.text.find_first_not_of("=<>:-~") == std::string_view::npos;
  if (is_mark && !found.is_end) {
    diagnostic.WithLabel(fmt::format("write '{}'", mark))
        .WithFix(found.span, std::string(mark));
  }
  return diagnostic;
}

// `thing` was opened at context.open and runs into the next item or the end.
Diagnostic Unclosed(const SyntaxContext& context, std::string_view thing) {
  const Found found = FoundAt(context.text, context.offset);
  return Diagnostic(Code::kUnclosedBrace, context.open,
                    fmt::format("this {} is never closed", thing))
      .WithLabel("opened here")
      .WithOther(found.span,
                 found.is_end ? "the file ends here; insert '}' before"
                              : "the next item starts here; insert '}' before")
      .WithFix({context.previous_end, context.previous_end}, "\n}");
}

Diagnostic InBraces(const SyntaxContext& context, std::string_view thing,
                    std::string_view what) {
  const Found found = FoundAt(context.text, context.offset);
  if (IsItemOrEnd(found)) return Unclosed(context, thing);
  Diagnostic diagnostic = Expected(context, Code::kStrayInBraces, what);
  if (thing == "production" && (found.text == "," || found.text == ";")) {
    diagnostic.WithLabel("symbols are separated by blanks")
        .WithFix(found.span, "");
  } else if (IsKeyword(found.text)) {
    diagnostic.label = "this word is reserved";
  }
  return diagnostic;
}

Diagnostic FirstSymbol(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  if (found.text != "}") return InBraces(context, "production", "a symbol");
  return Diagnostic(Code::kEmptyProduction,
                    {context.open.begin, found.span.end},
                    "a production has at least one symbol")
      .WithLabel("nothing to rewrite into")
      .WithNote("a symbol for which no rule is active stays as it is");
}

Diagnostic BodyDepth(const SyntaxContext& context) {
  return Diagnostic(Code::kLimit, CaretOf(context),
                    "an expected body is nested too deeply")
      .WithLabel("no robot of a scenario has limbs that long");
}

Diagnostic OfBody(SyntaxError error, const SyntaxContext& context) {
  switch (error) {
    case SyntaxError::kModule: {
      const Found before = FoundBefore(context.text, context.previous_end);
      return Expected(context, Code::kStrayInBraces,
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
        context, Code::kMissingMark,
        is_test ? "'{' or 'body' after '->'" : "'if' or '{' after '->'",
        is_test ? "the expected string stands in braces"
                : "a production stands in braces");
  return MissingMark(context, "{");
}

Diagnostic MissingNumber(const SyntaxContext& context, Code code,
                         std::string_view what) {
  if (auto number = DescribeNumberLike(context)) return *std::move(number);
  const Found before = FoundBefore(context.text, context.previous_end);
  return Expected(context, code,
                  fmt::format("{} after {}", what, before.quoted));
}

Diagnostic Argument(const SyntaxContext& context) {
  Diagnostic diagnostic =
      MissingNumber(context, Code::kMissingValue, "a number");
  if (context.text.substr(0, context.previous_end).ends_with('(') &&
      context.text.substr(context.offset).starts_with(')'))
    diagnostic.help =
        "a symbol without arguments is written without parentheses";
  return diagnostic;
}

Diagnostic SettingValue(const SyntaxContext& context) {
  const Found found = FoundAt(context.text, context.offset);
  Diagnostic diagnostic =
      MissingNumber(context, Code::kMissingValue, "a value");
  if (found.text == "=" || found.text == ":") {
    diagnostic.WithLabel(fmt::format("write '{} VALUE'", ItemWord(context)))
        .WithFix(found.span, "");
  }
  return diagnostic;
}

Diagnostic OfClause(SyntaxError error, const SyntaxContext& context) {
  if (auto foreign = DescribeForeign(error, context))
    return *std::move(foreign);
  const Found before = FoundBefore(context.text, context.previous_end);
  switch (error) {
    case SyntaxError::kTerm:
      return Expected(context, Code::kMissingTerm,
                      fmt::format("a term after {}", before.quoted),
                      "expected 'STATE = VALUE' here");
    case SyntaxError::kComparison:
      return DescribeMissingComparison(context);
    case SyntaxError::kThen:
      return DescribeMissingThen(context);
    default:
      return MissingNumber(context, Code::kMissingValue, "a value");
  }
}

Diagnostic OfType(SyntaxError error, const SyntaxContext& context) {
  switch (error) {
    case SyntaxError::kStateType:
      return Expected(context, Code::kMissingType, "a type",
                      "write 'bool', 'real in LOW..HIGH' or '{ NAME, NAME }'");
    case SyntaxError::kParameterType:
      return Expected(context, Code::kMissingType, "'real' or 'int'");
    case SyntaxError::kIn:
      return Expected(context, Code::kMissingMark, "'in' after 'real'",
                      "a real state has a range, as in 'real in -40..60'");
    case SyntaxError::kDots: {
      Diagnostic diagnostic = MissingMark(context, "..");
      diagnostic.label = "a range is written LOW..HIGH";
      return diagnostic;
    }
    case SyntaxError::kEnumEnd:
      return InBraces(context, "list of values", "',' or '}'");
    default:
      return Expected(context, Code::kIncompleteAlphabet, "a version or '{'",
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
      return Expected(context, Code::kBrokenList, "',' or ')'");
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
      return MissingNumber(context, Code::kMissingValue, "a number");
    default:
      return MissingNumber(context, Code::kMissingValue, "a value");
  }
}

Diagnostic Describe(SyntaxError error, const SyntaxContext& context) {
  using enum SyntaxError;
  switch (error) {
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
    case kInternal:
      break;
  }
  return Expected(context, Code::kParserDefect,
                  "something else (a defect of plsc)");
}

}  // namespace

Diagnostic DescribeSyntaxError(SyntaxError error,
                               const SyntaxContext& context) {
  Diagnostic diagnostic = Describe(error, context);
  ExplainForeignSyntax(error, context, &diagnostic);
  return diagnostic;
}

}  // namespace plsc
