// A client counts UTF-16 units in a line, we count bytes. Both ways are one
// binary search for the line and one for a mark: every kMarkDistance bytes the
// number of units before it is kept, so that a question counts within half a
// kilobyte, also in a line of megabytes. Bytes that are no UTF-8 count as a
// character each, and every place that a client may name is brought inside of
// the text.

#include "runtime/lsp/line_table.h"

#include <algorithm>
#include <iterator>

#include "grammar/utf8.h"

namespace plsc::lsp {

namespace {

constexpr std::uint32_t kMarkDistance = 512;

struct Units {
  std::uint32_t bytes = 1;
  std::uint32_t units = 1;
};

// The character that begins the text.
Units FirstCharacter(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  std::uint32_t wanted = 1;
  if (lead >= 0xF0U)
    wanted = 4;
  else if (lead >= 0xE0U)
    wanted = 3;
  else if (lead >= 0xC0U)
    wanted = 2;
  std::uint32_t bytes = 1;
  while (bytes < wanted && bytes < text.size() && GoesOn(text[bytes])) ++bytes;
  // Only characters beyond U+FFFF, those of four bytes, take two units.
  return {bytes, bytes == 4 ? 2U : 1U};
}

}  // namespace

std::uint32_t Utf16Length(std::string_view text) {
  std::uint32_t units = 0;
  while (!text.empty()) {
    const Units first = FirstCharacter(text);
    units += first.units;
    text.remove_prefix(first.bytes);
  }
  return units;
}

LineTable::LineTable(std::string_view text) : text_(text), begins_{0} {
  // Lines of genotypes have about 30 characters.
  begins_.reserve(text.size() / 24 + 1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\n' && text[i] != '\r') continue;
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') ++i;
    begins_.push_back(static_cast<std::uint32_t>(i + 1));
  }
  marks_.reserve(text.size() / kMarkDistance + 1);
  Mark at;
  while (at.offset < text.size()) {
    if (marks_.empty() || at.offset - marks_.back().offset >= kMarkDistance)
      marks_.push_back(at);
    const Units next = FirstCharacter(text.substr(at.offset));
    at.offset += next.bytes;
    at.units += next.units;
  }
  if (marks_.empty()) marks_.emplace_back();
}

std::uint32_t LineTable::UnitsBefore(std::uint32_t offset) const {
  const auto after =
      std::upper_bound(marks_.begin(), marks_.end(), offset,
                       [](std::uint32_t wanted, const Mark& mark) {
                         return wanted < mark.offset;
                       });
  const Mark& mark = *std::prev(after);
  return mark.units +
         Utf16Length(text_.substr(mark.offset, offset - mark.offset));
}

std::size_t LineTable::LineOf(std::uint32_t offset) const {
  const auto after = std::upper_bound(begins_.begin(), begins_.end(), offset);
  return static_cast<std::size_t>(after - begins_.begin()) - 1;
}

std::uint32_t LineTable::EndOf(std::size_t line) const {
  if (line + 1 == begins_.size())
    return static_cast<std::uint32_t>(text_.size());
  std::uint32_t end = begins_[line + 1] - 1;
  if (text_[end] == '\n' && end > begins_[line] && text_[end - 1] == '\r')
    --end;
  return end;
}

std::uint32_t LineTable::LineEnd(std::uint32_t offset) const {
  return EndOf(LineOf(offset));
}

Place LineTable::PlaceAt(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const std::size_t line = LineOf(offset);
  const std::uint32_t begin = begins_[line];
  // Between \r and \n is still the line's end to a client.
  const std::uint32_t end = std::min(offset, EndOf(line));
  return {static_cast<std::uint32_t>(line),
          UnitsBefore(end) - UnitsBefore(begin)};
}

std::uint32_t LineTable::OffsetAt(Place place) const {
  if (place.line >= begins_.size())
    return static_cast<std::uint32_t>(text_.size());
  std::uint32_t at = begins_[place.line];
  const std::uint32_t end = EndOf(place.line);
  const std::uint32_t before = UnitsBefore(at);
  // The last mark of the line that is not behind the place.
  const auto after =
      std::partition_point(marks_.begin(), marks_.end(), [&](const Mark& mark) {
        return mark.offset <= at ||
               (mark.offset <= end && mark.units - before <= place.character);
      });
  const Mark& mark = *std::prev(after);
  std::uint32_t units = 0;
  if (mark.offset > at) {
    units = mark.units - before;
    at = mark.offset;
  }
  while (at < end) {
    const Units next = FirstCharacter(text_.substr(at, end - at));
    if (units + next.units > place.character) break;
    units += next.units;
    at += next.bytes;
  }
  return at;
}

}  // namespace plsc::lsp
