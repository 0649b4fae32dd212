#include "grammar/foreign_file.h"

#include <algorithm>
#include <array>

namespace plsc {

namespace {

// Heads of lines in Revolve's text form, and tokens that no genotype of plsc
// has, at the commit that the paper cites.
constexpr std::array<std::string_view, 5> kHeads = {"C", "B", "AJ1", "AJ2",
                                                    "ST"};
constexpr std::array<std::string_view, 18> kTokens = {
    "AJ1",          "AJ2",
    "ST",           "addf",
    "addl",         "addr",
    "brainmoveFTS", "brainmoveTTS",
    "brainedge",    "brainloop",
    "brainperturb", "brainampperturb",
    "movef",        "brainperperturb",
    "movel",        "brainoffperturb",
    "mover",        "moveb",
};
// How far to look for a token: the first rule of any robot has one.
constexpr std::size_t kLookedAt = 4096;

template <std::size_t N>
bool IsOneOf(const std::array<std::string_view, N>& words,
             std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The next word at or behind `*at`; parameters follow a token behind '_'.
std::string_view NextWord(std::string_view text, std::size_t* at) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n", *at);
  if (begin == std::string_view::npos) {
    *at = text.size();
    return {};
  }
  *at = std::min(text.find_first_of(" \t\r\n", begin), text.size());
  const std::string_view word = text.substr(begin, *at - begin);
  return word.substr(0, word.find('_'));
}

// `C C brainmoveTTS_1|2 addf AJ1_0.5|2|3|4`
bool IsTokenText(std::string_view text) {
  std::size_t at = 0;
  if (!IsOneOf(kHeads, NextWord(text, &at))) return false;
  while (at < text.size())
    if (IsOneOf(kTokens, NextWord(text, &at))) return true;
  return false;
}

// `{<Alphabet.CORE_COMPONENT: 'C'>: [[...]]}`
bool IsPythonText(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos &&
         (text[begin] == '{' || text[begin] == '[' || text[begin] == '<') &&
         text.find("<Alphabet.") != std::string_view::npos;
}

}  // namespace

std::optional<Diagnostic> DescribeForeignFile(std::string_view text) {
  const std::size_t mark = TextBegin(text);
  const std::string_view start = text.substr(mark, kLookedAt);
  if (!IsPythonText(start) && !IsTokenText(start)) return std::nullopt;
  const auto begin =
      static_cast<std::uint32_t>(mark + start.find_first_not_of(" \t\r\n"));
  return Diagnostic(
             Code::kAuthorsGenotype, {begin, begin + 1},
             "this looks like a genotype of Revolve, the authors' program")
      .WithLabel("a genotype of plsc starts with 'plsc 1'")
      .WithNote(
          "Revolve's AJ1 is the paper's A2 and its AJ2 is A1; parameters are "
          "ordered w, a, p, o")
      .WithHelp("translate it: plsc import FILE -o robot.pls");
}

}  // namespace plsc
