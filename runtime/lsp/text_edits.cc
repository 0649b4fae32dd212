// A formatted text as one edit of the lines between the common beginning and
// the common end. An edit of everything would be right, and throw the editor's
// cursor, folds and marks away.

#include "runtime/lsp/text_edits.h"

#include <algorithm>

#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

// Bytes of whole lines that both begin with.
std::size_t CommonLines(std::string_view a, std::string_view b) {
  const std::size_t most = std::min(a.size(), b.size());
  const auto differs = std::mismatch(
      a.begin(), a.begin() + static_cast<std::ptrdiff_t>(most), b.begin());
  const auto same = static_cast<std::size_t>(differs.first - a.begin());
  const std::size_t line = a.substr(0, same).rfind('\n');
  return line == std::string_view::npos ? 0 : line + 1;
}

// Bytes of whole lines that both end with.
std::size_t CommonEnd(std::string_view a, std::string_view b) {
  const std::size_t most = std::min(a.size(), b.size());
  std::size_t same = 0;
  while (same < most && a[a.size() - 1 - same] == b[b.size() - 1 - same])
    ++same;
  const std::size_t line = a.find('\n', a.size() - same);
  return line == std::string_view::npos ? 0 : a.size() - line - 1;
}

}  // namespace

Json EditsTo(const Analysis& analysis, std::string_view changed) {
  const std::string_view text = analysis.text();
  if (text == changed) return Json::array();
  const std::size_t before = CommonLines(text, changed);
  const std::size_t after =
      CommonEnd(text.substr(before), changed.substr(before));
  const Span span{static_cast<std::uint32_t>(before),
                  static_cast<std::uint32_t>(text.size() - after)};
  const std::string replacement(
      changed.substr(before, changed.size() - after - before));
  return Json::array({TextEditJson(analysis.lines(), span, replacement)});
}

}  // namespace plsc::lsp
