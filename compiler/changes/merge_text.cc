// A piece of text is what it says, its comments and its layout. What it says
// and its comments may each be changed by one side; then the side that changed
// what it says gives the text, provided that the other side's comments are not
// lost with it. Layout alone never makes a conflict.
//
// Pieces of different files that are put together may run into each other: a
// word into a word, a comment into what follows. TextJoiner keeps them apart
// with a blank or a line's end, and only there, so that joining the pieces of
// one file gives that file.

#include "compiler/changes/merge_text.h"

#include <algorithm>
#include <cctype>

#include "compiler/changes/choose.h"
#include "compiler/changes/written_items.h"

namespace plsc {

namespace {

bool IsOfWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
         c == '.' || c == '-';
}

}  // namespace

std::optional<std::string> MergeText(const TextVersion& base,
                                     const TextVersion& ours,
                                     const TextVersion& theirs) {
  if (const std::string_view* chosen =
          Choose(base.text, ours.text, theirs.text))
    return std::string(*chosen);
  const auto old_comments = CommentsIn(base.text);
  const auto our_comments = CommentsIn(ours.text);
  const auto their_comments = CommentsIn(theirs.text);
  const bool is_ours_changed = ours.content != base.content;
  const bool is_theirs_changed = theirs.content != base.content;
  if (is_ours_changed && is_theirs_changed && ours.content != theirs.content)
    return std::nullopt;
  const bool takes_ours =
      is_ours_changed != is_theirs_changed
          ? is_ours_changed
          : our_comments != old_comments || their_comments == old_comments;
  const auto& taken = takes_ours ? our_comments : their_comments;
  const auto& left = takes_ours ? their_comments : our_comments;
  if (left != old_comments && left != taken) return std::nullopt;
  return std::string(takes_ours ? ours.text : theirs.text);
}

std::optional<std::string> MergeBlanks(std::string_view base,
                                       std::string_view ours,
                                       std::string_view theirs) {
  return MergeText({"", base}, {"", ours}, {"", theirs});
}

void TextJoiner::Append(std::string_view piece) {
  if (piece.empty()) return;
  const std::size_t first = piece.find_first_not_of(" \t\r");
  const bool begins_line =
      first != std::string_view::npos && piece[first] == '\n';
  if (is_own_line_ && begins_line) {
    is_own_line_ = false;
    return Append(piece.substr(first + 1));
  }
  is_own_line_ = false;
  if (is_comment_ && !begins_line) Add("\n");
  if (!text_.empty() && IsOfWord(text_.back()) && IsOfWord(piece.front()))
    Add(" ");
  Add(piece);
}

void TextJoiner::AppendLine(std::string_view line) {
  if (column_ > 0) Add("\n");
  Add(line);
  Add("\n");
  is_own_line_ = true;
}

void TextJoiner::Add(std::string_view piece) {
  text_ += piece;
  lines_ += static_cast<int>(std::count(piece.begin(), piece.end(), '\n'));
  const std::size_t end = piece.rfind('\n');
  const std::string_view last =
      end == std::string_view::npos ? piece : piece.substr(end + 1);
  if (end != std::string_view::npos) {
    column_ = 0;
    is_comment_ = false;
  }
  column_ += last.size();
  is_comment_ = is_comment_ || last.find('#') != std::string_view::npos;
}

}  // namespace plsc
