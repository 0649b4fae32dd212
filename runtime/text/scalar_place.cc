// Both texts are walked side by side. Between two characters of the text the
// file may have blanks; before the first one also a quote, or the header of a
// block to the end of its line.

#include "runtime/text/scalar_place.h"

#include <vector>

namespace plsc {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

bool IsBlank(char c) {
  return kBlanks.find(c) != std::string_view::npos;
}

std::size_t SkipBlanks(std::string_view file, std::size_t at) {
  while (at < file.size() && IsBlank(file[at])) ++at;
  return at;
}

/// Behind the quote or the header, if there is one.
std::size_t SkipOpening(std::string_view file, std::size_t at) {
  at = SkipBlanks(file, at);
  if (at >= file.size()) return at;
  if (file[at] == '"' || file[at] == '\'') return at + 1;
  if (file[at] != '|' && file[at] != '>') return at;
  const std::size_t end = file.find('\n', at);
  return end == std::string_view::npos ? file.size() : end;
}

}  // namespace

std::optional<Span> PlaceInScalar(std::string_view file, std::uint32_t begin,
                                  std::string_view text, Span part) {
  std::size_t at = SkipOpening(file, begin);
  std::optional<std::size_t> first;
  std::size_t end = at;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (IsBlank(text[i])) continue;
    at = SkipBlanks(file, at);
    if (at >= file.size() || file[at] != text[i]) return std::nullopt;
    if (i >= part.begin && !first) first = at;
    ++at;
    // An empty part stands behind what is before it.
    if (i < part.end || part.begin == part.end) end = at;
    if (first && i + 1 >= part.end) break;
  }
  if (!first) first = end;
  if (part.begin == part.end) end = *first;
  return Span{static_cast<std::uint32_t>(*first),
              static_cast<std::uint32_t>(end)};
}

}  // namespace plsc
