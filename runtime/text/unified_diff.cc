// The line edits of compiler/changes/line_edits as hunks with context, as `diff
// -u` prints them: two runs of changes that are nearer than twice the context
// share a hunk. A last line without an end is marked as diff does, or patching
// would add one.

#include "runtime/text/unified_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "compiler/changes/line_edits.h"
#include "grammar/shown_line.h"

namespace plsc {

namespace {

// Unchanged lines shown around a change, as `diff -u` and git have it.
constexpr std::size_t kContext = 3;
// "3,4": first line and count. An empty range is named by the line before it.
std::string RangeText(std::size_t before, std::size_t count) {
  if (count == 1) return fmt::format("{}", before + 1);
  return fmt::format("{},{}", count == 0 ? before : before + 1, count);
}

// Edits [begin, end) with the lines before them.
struct Hunk {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Changes nearer than twice the context share a hunk.
std::vector<Hunk> HunksOf(const std::vector<LineEdit>& edits) {
  std::vector<Hunk> hunks;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i] == LineEdit::kKeep) continue;
    const std::size_t begin = i > kContext ? i - kContext : 0;
    const std::size_t end = std::min(i + 1 + kContext, edits.size());
    if (hunks.empty() || begin > hunks.back().end)
      hunks.push_back({begin, end});
    else
      hunks.back().end = end;
  }
  return hunks;
}

}  // namespace

std::string UnifiedDiff(std::string_view old_text, std::string_view new_text,
                        std::string_view old_name, std::string_view new_name) {
  if (old_text == new_text) return "";
  const Lines a = SplitLines(old_text);
  const Lines b = SplitLines(new_text);
  const std::vector<LineEdit> edits = FindLineEdits(a, b);
  std::string text =
      fmt::format("--- {}\n+++ {}\n", Escaped(old_name), Escaped(new_name));
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t done = 0;
  for (const Hunk& hunk : HunksOf(edits)) {
    x += hunk.begin - done;  // only kept lines lie between hunks
    y += hunk.begin - done;
    std::string body;
    const std::size_t first_x = x;
    const std::size_t first_y = y;
    for (std::size_t i = hunk.begin; i < hunk.end; ++i) {
      const std::string_view line = edits[i] == LineEdit::kInsert ? b[y] : a[x];
      if (edits[i] != LineEdit::kInsert) ++x;
      if (edits[i] != LineEdit::kDelete) ++y;
      body += static_cast<char>(edits[i]);
      body += line;
      if (!line.ends_with('\n')) body += "\n\\ No newline at end of file\n";
    }
    text += fmt::format("@@ -{} +{} @@\n{}", RangeText(first_x, x - first_x),
                        RangeText(first_y, y - first_y), body);
    done = hunk.end;
  }
  return text;
}

std::vector<ChangedLines> LineChanges(std::string_view old_text,
                                      std::string_view new_text) {
  const Lines a = SplitLines(old_text);
  const Lines b = SplitLines(new_text);
  std::vector<ChangedLines> changes;
  std::size_t x = 0;
  std::size_t y = 0;
  std::size_t offset = 0;  // of line x
  bool is_open = false;
  for (const LineEdit edit : FindLineEdits(a, b)) {
    if (edit != LineEdit::kKeep && !is_open)
      changes.push_back({x, x, offset, offset, ""});
    is_open = edit != LineEdit::kKeep;
    if (edit != LineEdit::kInsert) offset += a[x++].size();
    if (edit == LineEdit::kInsert) changes.back().replacement += b[y];
    if (edit != LineEdit::kDelete) ++y;
    if (!is_open) continue;
    changes.back().end_line = x;
    changes.back().end = offset;
  }
  return changes;
}

}  // namespace plsc
