#pragma once

// A text and where things are in it. Every stage refers to places as byte
// offsets (Span); lines and columns are computed only when somebody reads
// them, because most texts have no errors.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plsc {

/// U+FEFF in UTF-8, which editors of some systems put before a text; it means
/// nothing.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// Where the text begins that it may stand before.
constexpr std::uint32_t TextBegin(std::string_view text) {
  return text.starts_with(kByteOrderMark)
             ? static_cast<std::uint32_t>(kByteOrderMark.size())
             : 0;
}

/// `text`, whose lines end in '\n', with the line ends of the first line of
/// `model`: '\n' or "\r\n".
std::string WithLineEndsOf(std::string_view model, std::string text);

/// Bytes [begin, end) of one source.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  friend bool operator==(const Span&, const Span&) = default;
};

/// 1-based; the column counts Unicode characters, a tab being one.
struct Position {
  int line = 1;
  int column = 1;
};

/// A named text. The name is what diagnostics print: the path as the user
/// wrote it, or "<stdin>", "--env".
class Source {
 public:
  Source(std::string name, std::string text);

  const std::string& name() const { return name_; }
  std::string_view text() const { return text_; }
  int line_count() const { return static_cast<int>(line_begins_.size()); }

  /// Offsets beyond the end count as the end.
  Position PositionOf(std::uint32_t offset) const;
  /// The first byte of the character there; nothing when the line or the
  /// column does not exist. The place behind a line's last character does.
  std::optional<std::uint32_t> OffsetOf(Position position) const;
  /// The line without its end; `line` in 1..line_count().
  std::string_view Line(int line) const;
  /// Offset of the first byte of `line`.
  std::uint32_t LineBegin(int line) const;

 private:
  std::string name_;
  std::string text_;
  std::vector<std::uint32_t> line_begins_;
  /// Characters before each whole block of bytes, so that a place on a line of
  /// millions costs no look at all of it.
  std::vector<std::uint32_t> block_characters_;

  std::size_t CharactersBefore(std::uint32_t offset) const;
};

}  // namespace plsc
