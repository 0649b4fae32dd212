#include "runtime/pictures/side_by_side.h"

#include <algorithm>

#include "grammar/utf8.h"

namespace plsc {

namespace {

constexpr std::size_t kBetween = 3;  // characters between blocks

struct Block {
  std::vector<std::string> lines;
  std::size_t width = 0;
};

Block SplitLines(const std::string& text) {
  Block block;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    block.lines.push_back(text.substr(at, end - at));
    block.width = std::max(block.width, CountCharacters(block.lines.back()));
    at = end + 1;
  }
  return block;
}

// Blocks [begin, end) beside each other.
std::string RowText(const std::vector<Block>& blocks, std::size_t begin,
                    std::size_t end) {
  std::size_t height = 0;
  for (std::size_t i = begin; i < end; ++i)
    height = std::max(height, blocks[i].lines.size());
  std::string text;
  for (std::size_t line = 0; line < height; ++line) {
    std::string whole;
    for (std::size_t i = begin; i < end; ++i) {
      const Block& block = blocks[i];
      const std::string part =
          line < block.lines.size() ? block.lines[line] : std::string();
      whole += part +
               std::string(block.width - CountCharacters(part) + kBetween, ' ');
    }
    whole.erase(whole.find_last_not_of(' ') + 1);
    text += whole + '\n';
  }
  return text;
}

}  // namespace

std::string SideBySide(const std::vector<std::string>& texts,
                       std::size_t columns) {
  std::vector<Block> blocks;
  blocks.reserve(texts.size());
  for (const std::string& text : texts) blocks.push_back(SplitLines(text));
  std::string all;
  for (std::size_t begin = 0; begin < blocks.size();) {
    std::size_t end = begin + 1;
    std::size_t width = blocks[begin].width;
    while (end < blocks.size() &&
           width + kBetween + blocks[end].width <= columns)
      width += kBetween + blocks[end++].width;
    if (begin > 0) all += '\n';
    all += RowText(blocks, begin, end);
    begin = end;
  }
  return all;
}

}  // namespace plsc
