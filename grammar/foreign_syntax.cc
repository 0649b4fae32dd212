// Habits of other languages, tried one after the other, the surest first: a
// character that only looks right explains any error, a comment mark of another
// language nearly any, arithmetic few. The first that knows what it sees adds
// to the message; it never decides whether there is an error. All lookalikes of
// an item are mended at once, because an item reports one error and few texts
// have only one of them.

#include "grammar/foreign_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "grammar/keywords.h"
#include "grammar/lookalike.h"
#include "grammar/lookaround.h"

namespace plsc {

namespace {

// What follows `at` without blanks of the same line.
std::string_view RestOf(std::string_view text, std::size_t at) {
  const std::size_t next = text.find_first_not_of(" \t", at);
  return next == std::string_view::npos ? std::string_view()
                                        : text.substr(next);
}

// Where the item ends at the latest: at the next line that begins with the
// keyword of one.
std::size_t EndOfItem(std::string_view text, std::size_t at) {
  while (true) {
    const std::size_t newline = text.find('\n', at);
    if (newline == std::string_view::npos) return text.size();
    const std::string_view line = RestOf(text, newline + 1);
    const auto end =
        std::find_if_not(line.begin(), line.end(), IsWordCharacter);
    if (IsItemKeyword(
            line.substr(0, static_cast<std::size_t>(end - line.begin()))))
      return newline;
    at = newline + 1;
  }
}

// All such characters of the rest of the item, outside of comments: an item
// reports one error, and few texts have only one of them.
void AddFixes(std::string_view text, std::size_t at, Diagnostic* diagnostic) {
  // As many as make a fix of one item; a hostile one may have millions.
  constexpr std::size_t kMaxFixes = 1000;
  const std::size_t end = EndOfItem(text, at);
  while (at < end && diagnostic->fixes.size() < kMaxFixes) {
    if (text[at] == '#') at = std::min(text.find('\n', at), end);
    const auto found = LookalikeAt(text.substr(at, end - at));
    if (!found) {
      ++at;
      continue;
    }
    const auto begin = static_cast<std::uint32_t>(at);
    at += found->bytes;
    diagnostic->fixes.push_back(
        {{begin, static_cast<std::uint32_t>(at)}, found->intended});
  }
}

std::string WhatIs(const Lookalike& found) {
  const std::string character = fmt::format("{} ({})", found.code, found.name);
  if (found.intended.empty()) return character + " stands here";
  if (found.intended == " " || found.intended == "\n")
    return character + " is none of the blanks of plsc";
  return fmt::format("{} is not '{}'", character, found.intended);
}

Diagnostic OfLookalike(const Lookalike& found, const SyntaxContext& context) {
  Diagnostic diagnostic(
      Code::kLookalike,
      {context.offset,
       context.offset + static_cast<std::uint32_t>(found.bytes)},
      WhatIs(found));
  AddFixes(context.text, context.offset, &diagnostic);
  const std::string& intended = found.intended;
  diagnostic.label = intended.empty()   ? "remove it"
                     : intended == " "  ? "write a blank"
                     : intended == "\n" ? "begin a new line"
                                        : fmt::format("write '{}'", intended);
  if (diagnostic.fixes.size() > 1)
    diagnostic.notes.push_back(fmt::format(
        "there are {} such characters in this item", diagnostic.fixes.size()));
  diagnostic.help =
      "outside of comments a file has letters, digits and marks of ASCII only";
  return diagnostic;
}

bool IsNumberOrWord(const Found& found) {
  return !found.text.empty() && IsWordCharacter(found.text.back());
}

std::string_view Mirrored(std::string_view comparison) {
  if (comparison == "<") return ">";
  if (comparison == "<=") return ">=";
  if (comparison == ">") return "<";
  if (comparison == ">=") return "<=";
  return comparison;
}

bool IsComparison(std::string_view word) {
  return word == "<" || word == "<=" || word == ">" || word == ">=" ||
         word == "=" || word == "!=" || word == "==";
}

bool IsNumber(std::string_view word) {
  return !word.empty() &&
         (word[0] == '-' || (word[0] >= '0' && word[0] <= '9'));
}

// The tokens of one line from `at` on, numbers with sign and fraction as one.
std::vector<Found> TokensOf(std::string_view text, std::size_t at,
                            std::size_t most) {
  std::vector<Found> tokens;
  while (tokens.size() < most) {
    at = text.find_first_not_of(" \t", at);
    if (at == std::string_view::npos || text[at] == '\n') break;
    std::size_t end = at;
    while (end < text.size() &&
           (IsWordCharacter(text[end]) || text[end] == '.' ||
            (text[end] == '-' && end == at)))
      ++end;
    if (end == at || (end == at + 1 && text[at] == '-')) {
      tokens.push_back(FoundAt(text, static_cast<std::uint32_t>(at)));
    } else {
      tokens.push_back(
          {{static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)},
           text.substr(at, end - at),
           "",
           false});
    }
    at = std::max<std::size_t>(tokens.back().span.end, at + 1);
  }
  return tokens;
}

// `10 < t` and `10 < t < 20`, in place of a term.
bool ExplainReversedTerm(const SyntaxContext& context, Diagnostic* diagnostic) {
  const std::vector<Found> tokens = TokensOf(context.text, context.offset, 5);
  if (tokens.size() < 3 || !IsNumber(tokens[0].text) ||
      !IsComparison(tokens[1].text) || !IsNumberOrWord(tokens[2]) ||
      IsNumber(tokens[2].text))
    return false;
  const std::string_view state = tokens[2].text;
  std::string right =
      fmt::format("{} {} {}", state, Mirrored(tokens[1].text), tokens[0].text);
  Span span{tokens[0].span.begin, tokens[2].span.end};
  if (tokens.size() == 5 && IsComparison(tokens[3].text) &&
      IsNumberOrWord(tokens[4]) && !IsKeyword(tokens[4].text)) {
    right +=
        fmt::format(" and {} {} {}", state, tokens[3].text, tokens[4].text);
    span.end = tokens[4].span.end;
  }
  diagnostic->span = span;
  diagnostic->message = "a state stands before what it is compared with";
  diagnostic->label = fmt::format("write '{}'", right);
  diagnostic->fixes = {{span, right}};
  return true;
}

// `t > 10 < 20`, or `0.5 * x` behind a term.
bool ExplainAfterTerm(const Found& found, Diagnostic* diagnostic) {
  if (!IsComparison(found.text)) return false;
  diagnostic->help =
      "a term compares once: write 'STATE > LOW and STATE < HIGH'";
  return true;
}

bool ExplainComment(const SyntaxContext& context, Diagnostic* diagnostic) {
  const std::string_view rest = context.text.substr(context.offset);
  const bool is_line = rest.starts_with("//");
  if (!is_line && !rest.starts_with("/*")) return false;
  diagnostic->code = Code::kForeignNotation;
  diagnostic->span = {context.offset, context.offset + 2};
  diagnostic->message =
      fmt::format("'{}' does not begin a comment in plsc", rest.substr(0, 2));
  diagnostic->label = "comments begin with '#' and end with the line";
  diagnostic->fixes.clear();
  diagnostic->help.clear();
  if (is_line) diagnostic->fixes.push_back({diagnostic->span, "#"});
  return true;
}

bool ExplainArithmetic(const Found& found, const Found& before,
                       Diagnostic* diagnostic) {
  if (found.text.empty() || !IsNumberOrWord(before)) return false;
  if (found.text.find_first_not_of("+-*/^%") != std::string_view::npos)
    return false;
  diagnostic->help = "nothing is computed in a file: write the result";
  return true;
}

bool ExplainBracket(const SyntaxContext& context, const Found& found,
                    Diagnostic* diagnostic) {
  if (found.text != "[") return false;
  const bool is_behind_name =
      context.offset > 0 && IsWordCharacter(context.text[context.offset - 1]);
  diagnostic->help =
      is_behind_name
          ? "arguments stand in parentheses"
          : "there are no brackets: 'move_back' returns to the module before; "
            "an alphabet of your own may have symbols such as push and pop";
  return true;
}

bool ExplainNamedArgument(SyntaxError error, const Found& found,
                          Diagnostic* diagnostic) {
  if (error != SyntaxError::kCloseParen ||
      (found.text != "=" && found.text != ":"))
    return false;
  diagnostic->help =
      "arguments have no names: write the values alone, in the order of the "
      "symbol's parameters";
  return true;
}

bool ExplainElse(const Found& found, Diagnostic* diagnostic) {
  if (found.text != "else" && found.text != "elif" && found.text != "elseif")
    return false;
  diagnostic->label.clear();
  diagnostic->fixes.clear();
  diagnostic->help =
      "there is no 'else': write a second rule with the opposite clause, as in "
      "'hot = False'";
  return true;
}

}  // namespace

void ExplainForeignSyntax(SyntaxError error, const SyntaxContext& context,
                          Diagnostic* diagnostic) {
  if (context.offset >= context.text.size()) return;
  if (const auto lookalike = LookalikeAt(context.text.substr(context.offset))) {
    *diagnostic = OfLookalike(*lookalike, context);
    return;
  }
  const Found found = FoundAt(context.text, context.offset);
  const Found before = FoundBefore(context.text, context.previous_end);
  // The first that knows what it is.
  static_cast<void>(
      ExplainComment(context, diagnostic) ||
      (error == SyntaxError::kTerm &&
       ExplainReversedTerm(context, diagnostic)) ||
      (error == SyntaxError::kThen && ExplainAfterTerm(found, diagnostic)) ||
      ExplainNamedArgument(error, found, diagnostic) ||
      ExplainBracket(context, found, diagnostic) ||
      ExplainElse(found, diagnostic) ||
      ExplainArithmetic(found, before, diagnostic));
}

}  // namespace plsc
