// What the whole number was meant to be: around the place where the parser
// stopped everything is taken that letters, digits, points and an exponent's
// sign join, since a message about "0x1F" helps and one about "x1F" does not.
// Each function knows one mistake; a fix is offered only where one correction
// is the only sensible one.

#include "grammar/number_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "grammar/keywords.h"
#include "grammar/lookaround.h"

namespace plsc {

namespace {

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

// The number around `offset` as it was meant: everything that letters,
// digits, '.' and the sign of an exponent join.
Span WholeNumber(std::string_view text, std::size_t offset) {
  const auto is_part = [&](std::size_t i) {
    const char c = text[i];
    if (IsWordCharacter(c) || c == '.') return true;
    return (c == '-' || c == '+') && i > 0 &&
           (text[i - 1] == 'e' || text[i - 1] == 'E');
  };
  std::size_t begin = std::min(offset, text.size());
  while (begin > 0 && is_part(begin - 1)) --begin;
  if (begin > 0 && text[begin - 1] == '-') --begin;
  std::size_t end = std::min(offset, text.size());
  while (end < text.size() && is_part(end)) ++end;
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

std::string_view TextOf(std::string_view text, Span span) {
  return text.substr(span.begin, span.end - span.begin);
}

Diagnostic Malformed(Span span, std::string message, std::string label) {
  return Diagnostic(Code::kMalformedNumber, span, std::move(message))
      .WithLabel(std::move(label));
}

Diagnostic Replace(Span span, std::string message, const std::string& right) {
  return Malformed(span, std::move(message), fmt::format("write '{}'", right))
      .WithFix(span, right);
}

bool IsHexadecimal(std::string_view number) {
  if (number.starts_with('-')) number.remove_prefix(1);
  return number.starts_with("0x") || number.starts_with("0X");
}

}  // namespace

bool IsNotFiniteWord(std::string_view word) {
  std::string lower(word.substr(0, 16));
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower == "nan" || lower == "inf" || lower == "infinity";
}

Diagnostic NotANumber(std::string_view text, Span span) {
  return Diagnostic(
             Code::kForeignNumber, span,
             fmt::format("'{}' is not a number in plsc", text.substr(0, 40)))
      .WithLabel("numbers are finite and decimal");
}

Diagnostic DescribeMissingDigits(const SyntaxContext& context) {
  const Span span = WholeNumber(context.text, context.offset);
  const std::string_view number = TextOf(context.text, span);
  const std::string_view before = context.text.substr(0, context.offset);
  if (before.ends_with('.')) {
    const std::string whole(number.substr(0, number.find('.')));
    Diagnostic diagnostic = Malformed(span, "expected digits after '.'", "");
    if (number.ends_with('.')) {
      diagnostic.WithLabel(fmt::format("write '{}.0' or '{}'", whole, whole))
          .WithFix(span, whole + ".0");
    }
    return diagnostic;
  }
  return Malformed(span,
                   fmt::format("expected digits after '{}'", before.back()),
                   "an exponent is a whole number, as in '1e-3'");
}

Diagnostic DescribeNumberEnd(const SyntaxContext& context) {
  const Span span = WholeNumber(context.text, context.offset);
  const std::string number(TextOf(context.text, span));
  const std::string_view rest =
      TextOf(context.text, {context.offset, span.end});
  if (IsHexadecimal(number)) return NotANumber(number, span);
  std::string digits = number;
  std::erase(digits, '_');
  const bool only_digits =
      std::all_of(digits.begin(), digits.end(),
                  [](char c) { return IsDigit(c) || c == '.' || c == '-'; });
  if (only_digits && digits.size() < number.size()) {
    return NotANumber(number, span)
        .WithLabel(fmt::format("write '{}'", digits))
        .WithFix(span, digits);
  }
  if (rest.starts_with('.'))
    return Malformed(span, fmt::format("'{}' has more than one '.'", number),
                     "a number has at most one");
  return Malformed(span,
                   fmt::format("expected the number to end before '{}'", rest),
                   "units and suffixes are not written");
}

std::optional<Diagnostic> DescribeNumberLike(const SyntaxContext& context) {
  const std::string_view text = context.text;
  std::size_t at = context.offset;
  if (at >= text.size()) return std::nullopt;
  const char sign = text[at] == '+' || text[at] == '-' ? text[at] : '\0';
  if (sign != '\0') ++at;
  if (at >= text.size()) return std::nullopt;
  const char next = at + 1 < text.size() ? text[at + 1] : '\0';
  const Span rest = WholeNumber(text, at + (text[at] == '.' ? 1 : 0));
  const Span span = {context.offset, std::max(rest.end, context.offset + 1)};
  const std::string_view number = TextOf(text, span);
  if (text[at] == '.' && IsDigit(next)) {
    const std::string minus = sign == '-' ? "-" : "";
    return Replace(
        span, "expected digits before '.'",
        fmt::format("{}0{}", minus, number.substr(sign != '\0' ? 1 : 0)));
  }
  if (sign == '+' && IsDigit(text[at]))
    return Replace(span, "a number has no '+' before it",
                   std::string(number.substr(1)));
  if (IsNotFiniteWord(number.substr(sign != '\0' ? 1 : 0)))
    return NotANumber(number, span);
  return std::nullopt;
}

}  // namespace plsc
