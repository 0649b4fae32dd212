#pragma once

// Between LSP's places and ours. A client counts lines from 0, ended by \n,
// \r\n or \r, and in a line UTF-16 code units (an emoji is two); we count
// bytes. Everything a client may say is brought to a place inside of the text.

#include <cstdint>
#include <string_view>
#include <vector>

#include "grammar/source.h"

namespace plsc::lsp {

/// LSP's `Position`.
struct Place {
  std::uint32_t line = 0;
  std::uint32_t character = 0;  ///< UTF-16 code units

  friend bool operator==(const Place&, const Place&) = default;
};

/// LSP's `Range`; the end does not belong to it.
struct PlaceRange {
  Place start;
  Place end;

  friend bool operator==(const PlaceRange&, const PlaceRange&) = default;
};

/// Where the lines of a text begin. The text must outlive it.
class LineTable {
 public:
  explicit LineTable(std::string_view text);

  std::uint32_t line_count() const {
    return static_cast<std::uint32_t>(begins_.size());
  }
  /// Offsets beyond the end count as the end.
  Place PlaceAt(std::uint32_t offset) const;
  PlaceRange RangeOf(Span span) const {
    return {PlaceAt(span.begin), PlaceAt(span.end)};
  }
  /// Characters beyond a line's end count as its end, lines beyond the last as
  /// the text's end, the middle of a character as its beginning.
  std::uint32_t OffsetAt(Place place) const;
  /// Of the line that `offset` is in, before its end.
  std::uint32_t LineEnd(std::uint32_t offset) const;

 private:
  // A character's place, one in every few hundred bytes: a line may be the
  // whole text, and a client asks about each of its tokens.
  struct Mark {
    std::uint32_t offset = 0;
    std::uint32_t units = 0;  // before it, of the whole text
  };

  std::size_t LineOf(std::uint32_t offset) const;
  std::uint32_t EndOf(std::size_t line) const;  // before \n, \r\n or \r
  std::uint32_t UnitsBefore(std::uint32_t offset) const;

  std::string_view text_;
  std::vector<std::uint32_t> begins_;
  std::vector<Mark> marks_;
};

/// Code units of a text. What is no UTF-8 has as many as bytes that begin
/// something.
std::uint32_t Utf16Length(std::string_view text);

}  // namespace plsc::lsp
