// The known word nearest to what was written, by the number of edits
// (Damerau-Levenshtein, two neighbouring letters that changed places being
// one). A word that differs in case alone wins outright; else a third of its
// letters may be wrong, two at most, because a suggestion that is not meant is
// worse than none. Of equally near words the first in the given order is taken,
// so that messages are the same each time.
//
// Length times length a pair, and a pair whose lengths differ too much is not
// looked at. Callers search a thousand names at most, for each report that is
// kept.

#include "grammar/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace plsc {

namespace {

constexpr int kMaxEdits = 2;
// No name that anybody means is longer; keeps hostile ones cheap.
constexpr std::size_t kMaxWord = 64;

char Lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool SameButCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return Lower(x) == Lower(y); });
}

}  // namespace

int EditDistance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  // Rows i - 2, i - 1 and i of the usual table.
  std::vector<int> before_last(width);
  std::vector<int> last(width);
  std::vector<int> row(width);
  for (std::size_t j = 0; j < width; ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replace, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    std::swap(before_last, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

std::optional<std::string> Suggest(std::string_view word,
                                   std::span<const std::string_view> known) {
  if (word.size() > kMaxWord) return std::nullopt;
  for (const std::string_view candidate : known)
    if (SameButCase(word, candidate)) return std::string(candidate);
  std::optional<std::string> best;
  int best_distance =
      std::min(kMaxEdits, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string_view candidate : known) {
    const auto difference =
        static_cast<int>(candidate.size()) - static_cast<int>(word.size());
    if (std::abs(difference) >= best_distance) continue;
    const int distance = EditDistance(word, candidate);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = std::string(candidate);
  }
  return best;
}

bool AddSuggestion(std::string_view word,
                   std::span<const std::string_view> known,
                   Diagnostic* diagnostic) {
  const auto near = Suggest(word, known);
  if (!near) return false;
  diagnostic->WithLabel(fmt::format("did you mean '{}'?", *near))
      .WithFix(diagnostic->span, *near);
  return true;
}

}  // namespace plsc
