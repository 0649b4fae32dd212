// Lines by a table of their beginnings and a binary search; columns are counted
// in characters, in the line, only when somebody asks. A file may be one line
// of 16 MB with hundreds of reports in it, each of which would count from the
// line's beginning: so characters are also counted once a block of 64 KB, and a
// question counts within a block.

#include "grammar/source.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "grammar/utf8.h"

namespace plsc {

namespace {

// Most texts are shorter, and so cost no pass.
constexpr std::size_t kBlock = 1U << 16U;

}  // namespace

std::string WithLineEndsOf(std::string_view model, std::string text) {
  const std::size_t end = model.find('\n');
  if (end == std::string_view::npos || end == 0 || model[end - 1] != '\r')
    return text;
  std::string with;
  with.reserve(text.size() + text.size() / 16);
  for (const char c : text) {
    if (c == '\n') with += '\r';
    with += c;
  }
  return with;
}

Source::Source(std::string name, std::string text)
    : name_(std::move(name)), text_(std::move(text)), line_begins_{0} {
  for (std::size_t i = text_.find('\n'); i != std::string::npos;
       i = text_.find('\n', i + 1))
    line_begins_.push_back(static_cast<std::uint32_t>(i + 1));
  block_characters_.push_back(0);
  for (std::size_t end = kBlock; end <= text_.size(); end += kBlock)
    block_characters_.push_back(
        block_characters_.back() +
        static_cast<std::uint32_t>(CountCharacters(
            std::string_view(text_).substr(end - kBlock, kBlock))));
}

std::size_t Source::CharactersBefore(std::uint32_t offset) const {
  const std::size_t block = offset / kBlock;
  return block_characters_[block] +
         CountCharacters(
             text().substr(block * kBlock, offset - block * kBlock));
}

Position Source::PositionOf(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const auto after =
      std::upper_bound(line_begins_.begin(), line_begins_.end(), offset);
  const auto line = static_cast<int>(after - line_begins_.begin());
  const std::uint32_t begin = LineBegin(line);
  const std::size_t characters =
      offset - begin < kBlock
          ? CountCharacters(text().substr(begin, offset - begin))
          : CharactersBefore(offset) - CharactersBefore(begin);
  return {line, static_cast<int>(characters) + 1};
}

std::optional<std::uint32_t> Source::OffsetOf(Position position) const {
  if (position.line < 1 || position.line > line_count() || position.column < 1)
    return std::nullopt;
  const std::string_view line = Line(position.line);
  int column = 0;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (!GoesOn(line[i]) && ++column == position.column)
      return LineBegin(position.line) + static_cast<std::uint32_t>(i);
  if (column + 1 != position.column) return std::nullopt;
  return LineBegin(position.line) + static_cast<std::uint32_t>(line.size());
}

std::uint32_t Source::LineBegin(int line) const {
  assert(line >= 1 && line <= line_count());
  return line_begins_[static_cast<std::size_t>(line - 1)];
}

std::string_view Source::Line(int line) const {
  const std::uint32_t begin = LineBegin(line);
  std::size_t end =
      line < line_count() ? LineBegin(line + 1) - 1u : text_.size();
  if (end > begin && text_[end - 1] == '\r') --end;
  return std::string_view(text_).substr(begin, end - begin);
}

}  // namespace plsc
