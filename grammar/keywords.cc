#include "grammar/keywords.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace plsc {

namespace {

constexpr std::array<std::string_view, 13> kItemKeywords = {
    "alphabet", "axiom",       "environment", "genotype",  "iterations",
    "let",      "max_modules", "max_rules",   "max_terms", "move_to_new",
    "rule",     "sense",       "test",
};

// `include` has no meaning yet: reserved, so that files of today stay valid
// when it gets one.
constexpr std::array<std::string_view, 15> kOtherKeywords = {
    "False", "True",    "and",         "bool",     "if",
    "in",    "include", "int",         "not",      "or",
    "plsc",  "real",    "replaceable", "terminal", "then",
};

// A row of kKeywordLengths. The first and the last byte tell names of symbols
// from keywords better than two at the start (move_back, move_to_new).
constexpr std::size_t RowOf(std::string_view word) {
  return (31U * static_cast<unsigned char>(word.front()) +
          static_cast<unsigned char>(word.back())) %
         256;
}

// Which lengths the keywords of a row have, a bit a length. Every name of every
// production is asked about, and nearly none passes this.
constexpr auto kKeywordLengths = [] {
  std::array<std::uint32_t, 256> lengths{};
  for (const std::string_view word : kItemKeywords)
    lengths[RowOf(word)] |= 1U << word.size();
  for (const std::string_view word : kOtherKeywords)
    lengths[RowOf(word)] |= 1U << word.size();
  return lengths;
}();

bool MayBeKeyword(std::string_view word) {
  // A keyword of 32 letters would not compile above.
  return !word.empty() && word.size() < 32 &&
         (kKeywordLengths[RowOf(word)] >> word.size() & 1U) != 0;
}

template <std::size_t N>
bool Contains(const std::array<std::string_view, N>& words,
              std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool IsIdentifier(std::string_view text) {
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9') &&
         std::all_of(text.begin(), text.end(), IsWordCharacter);
}

}  // namespace

std::span<const std::string_view> ItemKeywords() {
  return kItemKeywords;
}

bool IsItemKeyword(std::string_view word) {
  return MayBeKeyword(word) && Contains(kItemKeywords, word);
}

bool IsKeyword(std::string_view word) {
  return MayBeKeyword(word) &&
         (Contains(kOtherKeywords, word) || Contains(kItemKeywords, word));
}

bool IsName(std::string_view text) {
  return IsIdentifier(text) && !IsKeyword(text);
}

bool IsGenotypeName(std::string_view text) {
  return IsIdentifier(text) && (!IsItemKeyword(text) || text == "test");
}

}  // namespace plsc
