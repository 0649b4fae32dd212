// Myers' greedy algorithm (1986) over lines: the edit graph is walked by
// diagonals k = x - y, and for each number of differences d the furthest point
// of each diagonal is kept. The first d that reaches the end is the shortest
// script, read back from the rows that were kept. Memory is the square of the
// differences, time at most the texts times the differences: equal ends go
// first, and the search gives up at kMaxDifferences.

#include "compiler/changes/line_edits.h"

#include <algorithm>
#include <cstddef>

namespace plsc {

namespace {

// Most differing lines that the shortest script is searched for; the search
// keeps a row a difference, so 2,000 take 16 MB. Beyond, everything between
// the common ends counts as changed: right, only longer.
constexpr int kMaxDifferences = 2000;

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
  std::vector<LineEdit> Run() {
    const int limit = std::min(n_ + m_, kMaxDifferences);
    for (int d = 0; d <= limit; ++d)
      if (Advance(d)) return Backtrack(d);
    std::vector<LineEdit> all(static_cast<std::size_t>(n_), LineEdit::kDelete);
    all.insert(all.end(), static_cast<std::size_t>(m_), LineEdit::kInsert);
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
  std::vector<LineEdit> Backtrack(int d) {
    std::vector<LineEdit> edits;
    int x = n_;
    int y = m_;
    for (; d > 0; --d) {
      const int k = x - y;
      const bool is_insert = IsInsert(d, k);
      const int from_x = At(d - 1, is_insert ? k + 1 : k - 1);
      const int from_y = from_x - (is_insert ? k + 1 : k - 1);
      const int after_x = is_insert ? from_x : from_x + 1;
      edits.insert(edits.end(), static_cast<std::size_t>(x - after_x),
                   LineEdit::kKeep);
      edits.push_back(is_insert ? LineEdit::kInsert : LineEdit::kDelete);
      x = from_x;
      y = from_y;
    }
    edits.insert(edits.end(), static_cast<std::size_t>(x), LineEdit::kKeep);
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

}  // namespace

Lines SplitLines(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

std::vector<LineEdit> FindLineEdits(const Lines& a, const Lines& b) {
  std::size_t begin = 0;
  while (begin < a.size() && begin < b.size() && a[begin] == b[begin]) ++begin;
  std::size_t a_end = a.size();
  std::size_t b_end = b.size();
  while (a_end > begin && b_end > begin && a[a_end - 1] == b[b_end - 1]) {
    --a_end;
    --b_end;
  }
  std::vector<LineEdit> edits(begin, LineEdit::kKeep);
  const std::vector<LineEdit> middle = Search(a, b, begin, a_end, b_end).Run();
  edits.insert(edits.end(), middle.begin(), middle.end());
  edits.insert(edits.end(), a.size() - a_end, LineEdit::kKeep);
  return edits;
}

}  // namespace plsc
