#include "grammar/keywords.h"

#include <algorithm>
#include <array>

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

template <std::size_t N>
bool Contains(const std::array<std::string_view, N>& words,
              std::string_view word) {
  // Every name of every production is looked up: most fail at the first byte.
  return std::any_of(words.begin(), words.end(), [&](std::string_view known) {
    return known[0] == word[0] && known == word;
  });
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
  return !word.empty() && Contains(kItemKeywords, word);
}

bool IsKeyword(std::string_view word) {
  return !word.empty() &&
         (Contains(kOtherKeywords, word) || Contains(kItemKeywords, word));
}

bool IsName(std::string_view text) {
  return IsIdentifier(text) && !IsKeyword(text);
}

bool IsGenotypeName(std::string_view text) {
  return IsIdentifier(text) && (!IsItemKeyword(text) || text == "test");
}

}  // namespace plsc
