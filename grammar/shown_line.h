#pragma once

// Text of a user's as it may be shown: a hostile file must neither drive the
// terminal nor flood it. Used by the rendering of diagnostics and
// by every command that prints names.

#include <string>
#include <string_view>
#include <vector>

namespace plsc {

/// A line as columns, each one character: tabs are blanks, and what is no
/// printable character (controls, direction marks, bytes that are not UTF-8)
/// is '?'.
struct ShownLine {
  std::vector<std::string> columns;
  /// The column of each byte of the line, and one past the last.
  std::vector<std::size_t> column_of_byte;

  /// Columns [from, from + count), or to the end.
  std::string Text(std::size_t from, std::size_t count) const;
};

ShownLine ShownLineOf(std::string_view line);

/// One line of text with every unprintable character as '?', cut to `limit`
/// characters and "..." if it is longer.
std::string Printable(std::string_view text, std::size_t limit);

/// Anybody's name or message inside a line of ours: an unprintable character is
/// written as its escape ("\\n", "\\x1b", "\\u202e"), all others as they are.
/// For everything that is foreign in a text for people: names of runs, seasons
/// and files, reasons of other programs.
std::string Escaped(std::string_view text);

}  // namespace plsc
