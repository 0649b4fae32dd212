#include "grammar/keywords.h"

#include <algorithm>
#include <array>

namespace plsc {

namespace {

constexpr std::array<std::string_view, 12> kItemKeywords = {
    "alphabet",   "axiom",       "environment", "genotype",
    "iterations", "let",         "max_modules", "max_rules",
    "max_terms",  "move_to_new", "rule",        "sense",
};

// `include` and `test` have no meaning yet: reserved, so that files of today
// stay valid when they get one.
constexpr std::array<std::string_view, 16> kOtherKeywords = {
    "False", "True", "and",  "bool", "if",          "in",   "include",  "int",
    "not",   "or",   "plsc", "real", "replaceable", "test", "terminal", "then",
};

template <std::size_t N>
bool Contains(const std::array<std::string_view, N>& words,
              std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::span<const std::string_view> ItemKeywords() {
  return kItemKeywords;
}

bool IsItemKeyword(std::string_view word) {
  return Contains(kItemKeywords, word);
}

bool IsKeyword(std::string_view word) {
  return Contains(kOtherKeywords, word) || IsItemKeyword(word);
}

bool IsName(std::string_view text) {
  return !text.empty() && !(text[0] >= '0' && text[0] <= '9') &&
         std::all_of(text.begin(), text.end(), IsWordCharacter) &&
         !IsKeyword(text);
}

}  // namespace plsc
