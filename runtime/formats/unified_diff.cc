#include "runtime/formats/unified_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace plsc {

namespace {

using Lines = std::vector<std::string_view>;

// Unchanged lines shown around a change, as `diff -u` and git have it.
constexpr std::size_t kContext = 3;
// Most differing lines that the shortest script is searched for; the search
// keeps a row a difference, so 2,000 take 16 MB. Beyond, everything between
// the common ends counts as changed: right, only longer.
constexpr int kMaxDifferences = 2000;

// With their ends, so that "a\r\n" and "a\n" differ.
Lines SplitLines(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

// One line of the script: in the old text, in the new one, or in both.
enum class Edit : char { kKeep = ' ', kDelete = '-', kInsert = '+' };

// The middle of two texts: what is left between their common ends.
class Search {
 public:
  Search(const Lines& a, const Lines& b, std::size_t begin, std::size_t a_end,
         std::size_t b_end)
      : a_(a),
        b_(b),
        begin_(begin),
        n_(static_cast<int>(a_end - begin)),
        m_(static_cast<int>(b_end - begin)) {}

  // The edits from begin to the ends, in order.
  std::vector<Edit> Run() {
    const int limit = std::min(n_ + m_, kMaxDifferences);
    for (int d = 0; d <= limit; ++d)
      if (Advance(d)) return Backtrack(d);
    std::vector<Edit> all(static_cast<std::size_t>(n_), Edit::kDelete);
    all.insert(all.end(), static_cast<std::size_t>(m_), Edit::kInsert);
    return all;
  }

 private:
  // rows_[d][k + d]: how far into `a` d differences reach on the diagonal
  // k = x - y, -d <= k <= d.
  int& At(int d, int k) {
    const int column = k + d;
    return rows_[static_cast<std::size_t>(d)][static_cast<std::size_t>(column)];
  }
  // Whether the best way to diagonal k with d differences comes from above,
  // by inserting a line of `b`.
  bool IsInsert(int d, int k) {
    return k == -d || (k != d && At(d - 1, k - 1) < At(d - 1, k + 1));
  }
  bool Advance(int d) {
    rows_.emplace_back(2 * static_cast<std::size_t>(d) + 1, 0);
    for (int k = -d; k <= d; k += 2) {
      int x = 0;
      if (d > 0) x = IsInsert(d, k) ? At(d - 1, k + 1) : At(d - 1, k - 1) + 1;
      int y = x - k;
      while (x < n_ && y < m_ && y >= 0 &&
             a_[begin_ + static_cast<std::size_t>(x)] ==
                 b_[begin_ + static_cast<std::size_t>(y)]) {
        ++x;
        ++y;
      }
      At(d, k) = x;
      if (x >= n_ && y >= m_) return true;
    }
    return false;
  }
  std::vector<Edit> Backtrack(int d) {
    std::vector<Edit> edits;
    int x = n_;
    int y = m_;
    for (; d > 0; --d) {
      const int k = x - y;
      const bool is_insert = IsInsert(d, k);
      const int from_x = At(d - 1, is_insert ? k + 1 : k - 1);
      const int from_y = from_x - (is_insert ? k + 1 : k - 1);
      const int after_x = is_insert ? from_x : from_x + 1;
      edits.insert(edits.end(), static_cast<std::size_t>(x - after_x),
                   Edit::kKeep);
      edits.push_back(is_insert ? Edit::kInsert : Edit::kDelete);
      x = from_x;
      y = from_y;
    }
    edits.insert(edits.end(), static_cast<std::size_t>(x), Edit::kKeep);
    std::reverse(edits.begin(), edits.end());
    return edits;
  }

  const Lines& a_;
  const Lines& b_;
  std::size_t begin_;
  int n_;
  int m_;
  std::vector<std::vector<int>> rows_;
};

std::vector<Edit> Script(const Lines& a, const Lines& b) {
  std::size_t begin = 0;
  while (begin < a.size() && begin < b.size() && a[begin] == b[begin]) ++begin;
  std::size_t a_end = a.size();
  std::size_t b_end = b.size();
  while (a_end > begin && b_end > begin && a[a_end - 1] == b[b_end - 1]) {
    --a_end;
    --b_end;
  }
  std::vector<Edit> edits(begin, Edit::kKeep);
  const std::vector<Edit> middle = Search(a, b, begin, a_end, b_end).Run();
  edits.insert(edits.end(), middle.begin(), middle.end());
  edits.insert(edits.end(), a.size() - a_end, Edit::kKeep);
  return edits;
}

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
std::vector<Hunk> HunksOf(const std::vector<Edit>& edits) {
  std::vector<Hunk> hunks;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    if (edits[i] == Edit::kKeep) continue;
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
  const std::vector<Edit> edits = Script(a, b);
  std::string text = fmt::format("--- {}\n+++ {}\n", old_name, new_name);
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
      const std::string_view line = edits[i] == Edit::kInsert ? b[y] : a[x];
      if (edits[i] != Edit::kInsert) ++x;
      if (edits[i] != Edit::kDelete) ++y;
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

}  // namespace plsc
