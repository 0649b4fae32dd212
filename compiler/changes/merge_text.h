#pragma once

// Three versions of a piece of text made into one: what it says and its
// comments are merged, its layout comes along. And the joining of pieces that
// come from different files.

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace plsc {

/// A piece and what it says, without blanks and comments.
struct TextVersion {
  std::string_view content;
  std::string_view text;
};

/// Nothing when both sides changed what it says, or its comments, in different
/// ways.
std::optional<std::string> MergeText(const TextVersion& base,
                                     const TextVersion& ours,
                                     const TextVersion& theirs);

/// Of blanks and comments.
std::optional<std::string> MergeBlanks(std::string_view base,
                                       std::string_view ours,
                                       std::string_view theirs);

/// Appends pieces so that none changes what another says: no word grows, and a
/// comment ends with its line.
class TextJoiner {
 public:
  void Append(std::string_view piece);
  /// A line of its own; the end of the line that the next piece may begin with
  /// is this one's.
  void AppendLine(std::string_view line);
  /// From 1: the line on which AppendLine would write.
  int next_line() const { return lines_ + (column_ > 0 ? 2 : 1); }
  std::string Text() && { return std::move(text_); }

 private:
  void Add(std::string_view piece);

  std::string text_;
  int lines_ = 0;             // that ended
  std::size_t column_ = 0;    // bytes of the last line
  bool is_own_line_ = false;  // whether the last line was one of its own
  bool is_comment_ = false;   // whether the last line ends in one
};

}  // namespace plsc
