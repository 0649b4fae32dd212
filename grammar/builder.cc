// Parts of an item are put into the pools of the file while it is matched, and
// the item itself is added when it is complete: of one that fails unused
// elements stay in the pools, which nobody refers to. Numbers are read here and
// held to a double's range; a number of the right kind takes the place of one
// that does not fit, so that later stages say nothing more about it.

#include "grammar/builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "grammar/number.h"

namespace plsc::grammar {

namespace {

template <typename T>
std::uint32_t SizeOf(const std::vector<T>& pool) {
  return static_cast<std::uint32_t>(pool.size());
}

// Whether a number written this way is zero: only then may its double be.
bool IsWrittenZero(std::string_view number) {
  const std::string_view digits = number.substr(0, number.find_first_of("eE"));
  return digits.find_first_of("123456789") == std::string_view::npos;
}

}  // namespace

void Builder::BeginItem(Span item_keyword) {
  keyword = item_keyword;
  open = close = Span{};
  bounds = {};
  connective = ast::Connective::kNone;
  rule = {};
  rule.terms.first = SizeOf(file.terms);
  rule.symbols.first = SizeOf(file.symbols);
  alphabet = {};
  alphabet.declarations.first = SizeOf(file.declarations);
  sense = {};
  sense.values.first = SizeOf(file.names);
  environment = {};
  environment.entries.first = SizeOf(file.entries);
  test = {};
  test.nodes.first = SizeOf(file.nodes);
  body_path.clear();
}

void Builder::EndItem(ast::ItemKind kind, std::size_t index) {
  file.items.push_back({kind,
                        {keyword.begin, previous_end},
                        keyword,
                        static_cast<std::uint32_t>(index)});
}

void Builder::TakeNumber(Span span) {
  const std::string_view text = file.Text(span);
  value = {};
  value.span = span;
  // Not find_first_of, which calls memchr for each character.
  value.is_integer = std::none_of(text.begin(), text.end(), [](char c) {
    return c == '.' || c == 'e' || c == 'E';
  });
  const LeadingNumber<double> read = ReadNumber<double>(text);
  value.number = read.value;
  const bool fits = read.kind == LeadingNumber<double>::Kind::kFits;
  if (fits && (value.number != 0 || IsWrittenZero(text))) return;
  // What follows needs some number in its place.
  value.number = 1;
  const std::size_t exponent = text.find_first_of("eE");
  const bool is_small =
      (exponent != std::string_view::npos && text[exponent + 1] == '-') ||
      (exponent == std::string_view::npos && text.find('.') < 3);
  reporter
      .Report(Code::kBeyondDouble, span,
              fmt::format("{} does not fit a 64-bit floating-point number",
                          text.size() > 40 ? "this number" : text))
      .WithLabel(is_small ? "smallest magnitude is 5e-324"
                          : "largest magnitude is 1.7976931348623157e308");
}

void Builder::CheckTermValue() {
  if (value.kind != ast::Value::Kind::kName) return;
  const std::string_view text = file.Text(value.span);
  const bool is_true = text == "true" || text == "TRUE";
  if (!is_true && text != "false" && text != "FALSE") return;
  const char* const right = is_true ? "True" : "False";
  value.kind = is_true ? ast::Value::Kind::kTrue : ast::Value::Kind::kFalse;
  reporter
      .Report(Code::kForeignNotation, value.span,
              fmt::format("'{}' is not a plsc value", text))
      .WithLabel(fmt::format("use '{}'", right))
      .WithFix(value.span, right);
}

void Builder::Fail(SyntaxError error, std::uint32_t offset) {
  file.is_incomplete = true;
  if (!reporter.is_full())
    reporter.Add(DescribeSyntaxError(
        error, {file.text, offset, previous_end, keyword, open}));
  throw SyntaxFailure{};
}

}  // namespace plsc::grammar
