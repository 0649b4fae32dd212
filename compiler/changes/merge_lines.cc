// The classical three-way merge of lines: a line that both sides still have is
// an anchor, and between two anchors each version has a piece. A piece that one
// side left as it was, or that both have alike, is taken; others are a conflict
// with all three versions. Only lines that both sides kept are anchors, so a
// moved line is a deletion and an insertion, as in git.

#include "compiler/changes/merge_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "compiler/changes/choose.h"
#include "compiler/changes/line_edits.h"

namespace plsc {

namespace {

constexpr std::size_t kNoLine = static_cast<std::size_t>(-1);

// By line of `base`: which line of `other` it still is, or kNoLine.
std::vector<std::size_t> Followed(const Lines& base, const Lines& other) {
  std::vector<std::size_t> followed;
  std::size_t at = 0;
  for (const LineEdit edit : FindLineEdits(base, other)) {
    if (edit == LineEdit::kInsert)
      ++at;
    else
      followed.push_back(edit == LineEdit::kKeep ? at++ : kNoLine);
  }
  return followed;
}

// What one version has at a place where the versions differ.
struct Piece {
  Lines::const_iterator begin;
  Lines::const_iterator end;

  bool operator==(const Piece& other) const {
    return std::equal(begin, end, other.begin, other.end);
  }
};

class LineMerger {
 public:
  LineMerger(std::string_view base, std::string_view ours,
             std::string_view theirs, const MergeLabels& labels)
      : base_(SplitLines(base)),
        ours_(SplitLines(ours)),
        theirs_(SplitLines(theirs)),
        labels_(labels),
        line_end_(!ours_.empty() && ours_[0].ends_with("\r\n") ? "\r\n"
                                                               : "\n") {}

  MergedFile Run() {
    const auto in_ours = Followed(base_, ours_);
    const auto in_theirs = Followed(base_, theirs_);
    for (std::size_t line = 0; line < base_.size(); ++line) {
      if (in_ours[line] == kNoLine || in_theirs[line] == kNoLine) continue;
      MergeUntil(line, in_ours[line], in_theirs[line]);
      Add(base_[line]);
      ++base_done_;
      ++ours_done_;
      ++theirs_done_;
    }
    MergeUntil(base_.size(), ours_.size(), theirs_.size());
    return std::move(merged_);
  }

 private:
  static Piece Take(const Lines& lines, std::size_t& done, std::size_t until) {
    const auto at = [&](std::size_t line) {
      return lines.begin() + static_cast<std::ptrdiff_t>(line);
    };
    const Piece piece{at(done), at(until)};
    done = until;
    return piece;
  }

  // Up to the next line that all three have.
  void MergeUntil(std::size_t base_until, std::size_t ours_until,
                  std::size_t theirs_until) {
    const Piece base = Take(base_, base_done_, base_until);
    const Piece ours = Take(ours_, ours_done_, ours_until);
    const Piece theirs = Take(theirs_, theirs_done_, theirs_until);
    if (const Piece* chosen = Choose(base, ours, theirs))
      Add(*chosen);
    else
      AddConflict(base, ours, theirs);
  }

  void AddConflict(const Piece& base, const Piece& ours, const Piece& theirs) {
    EndLine();
    merged_.conflicts.push_back(
        {lines_ + 1, fmt::format("changed in different ways in {} and {}",
                                 labels_.ours, labels_.theirs)});
    AddMarker('<', labels_.ours);
    Add(ours);
    AddMarker('|', labels_.base);
    Add(base);
    AddMarker('=', "");
    Add(theirs);
    AddMarker('>', labels_.theirs);
  }

  void AddMarker(char sign, const std::string& label) {
    EndLine();
    const std::string signs(static_cast<std::size_t>(labels_.marker_size),
                            sign);
    Add(fmt::format("{}{}{}{}", signs, label.empty() ? "" : " ", label,
                    line_end_));
  }

  void EndLine() {
    if (!merged_.text.empty() && !merged_.text.ends_with('\n')) Add(line_end_);
  }

  void Add(const Piece& piece) {
    for (auto line = piece.begin; line != piece.end; ++line) Add(*line);
  }

  void Add(std::string_view text) {
    merged_.text += text;
    if (text.ends_with('\n')) ++lines_;
  }

  const Lines base_;
  const Lines ours_;
  const Lines theirs_;
  const MergeLabels& labels_;
  const std::string_view line_end_;
  std::size_t base_done_ = 0;
  std::size_t ours_done_ = 0;
  std::size_t theirs_done_ = 0;
  int lines_ = 0;
  MergedFile merged_;
};

}  // namespace

MergedFile MergeLines(std::string_view base, std::string_view ours,
                      std::string_view theirs, const MergeLabels& labels) {
  return LineMerger(base, ours, theirs, labels).Run();
}

}  // namespace plsc
