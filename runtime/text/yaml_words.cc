#include "runtime/text/yaml_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "grammar/number.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}

// "1,000,000" without what separates groups of three digits.
std::string WithoutSeparators(std::string text) {
  for (std::size_t at = 1; at + 3 < text.size(); ++at) {
    const bool is_separator =
        text[at] == ',' || text[at] == '_' || text[at] == '\'';
    if (is_separator && IsDigit(text[at - 1]) && IsDigit(text[at + 1]) &&
        IsDigit(text[at + 2]) && IsDigit(text[at + 3]) &&
        (at + 4 == text.size() || !IsDigit(text[at + 4])))
      text.erase(at, 1);
  }
  return text;
}

template <std::size_t N>
bool IsOneOf(const std::array<std::string_view, N>& words,
             std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::optional<std::int64_t> WholeNumberMeant(std::string text) {
  text = WithoutSeparators(std::move(text));
  const LeadingNumber<double> read = ReadNumber<double>(text);
  const double number = read.value;
  const std::string_view rest = std::string_view(text).substr(read.length);
  constexpr double kExact = 9007199254740992;  // 2^53
  if (read.kind != LeadingNumber<double>::Kind::kFits ||
      rest.starts_with(',') || rest.find('%') != std::string_view::npos ||
      rest.find("cent") != std::string_view::npos ||
      !(std::abs(number) <= kExact) || number != std::floor(number))
    return std::nullopt;
  return static_cast<std::int64_t>(number);
}

std::string TruthMeant(std::string_view text) {
  constexpr std::array<std::string_view, 6> kTrue = {"true", "yes", "on",
                                                     "y",    "t",   "1"};
  constexpr std::array<std::string_view, 6> kFalse = {"false", "no", "off",
                                                      "n",     "f",  "0"};
  const std::string lower = Lower(text);
  if (IsOneOf(kTrue, lower)) return "True";
  if (IsOneOf(kFalse, lower)) return "False";
  const std::vector<std::string_view> words = {"True", "False"};
  return Suggest(text, words).value_or("");
}

bool IsYamlWord(std::string_view word) {
  // In any case: some readers take more spellings than the standards have.
  constexpr std::array<std::string_view, 11> kWords = {
      "null", "true", "false", "yes", "no", "on",
      "off",  "y",    "n",     "inf", "nan"};
  return IsOneOf(kWords, Lower(word));
}

}  // namespace plsc
