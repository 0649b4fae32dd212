#include "grammar/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/shown_line.h"

namespace plsc {

namespace {

// Longest shown line in characters; a minified file must not flood a terminal.
constexpr std::size_t kMaxShown = 160;
// Longest message, label, note or help that is shown in full, in characters:
// they quote names, and a hostile name could be megabytes long.
constexpr std::size_t kMaxMessage = 400;

std::string Clip(std::string_view text) {
  return Printable(text, kMaxMessage);
}

// One source line with `mark` repeated under the bytes of `span`.
std::string ShowPlace(const Source& source, Span span, char mark,
                      std::string_view label, std::size_t gutter) {
  const int line_number = source.PositionOf(span.begin).line;
  const std::string_view line = source.Line(line_number);
  const std::uint32_t line_begin = source.LineBegin(line_number);
  const ShownLine shown = Show(line);
  const auto column_at = [&](std::uint32_t offset) {
    return shown.column_of_byte[std::min<std::size_t>(offset - line_begin,
                                                      line.size())];
  };
  std::size_t first = column_at(span.begin);
  const std::size_t last = column_at(std::max(span.end, span.begin));
  std::size_t width = last > first ? last - first : 1;
  std::string shown_text = shown.Text(0, shown.columns.size());
  if (shown.columns.size() > kMaxShown) {
    const std::size_t from = first > kMaxShown / 2 ? first - kMaxShown / 2 : 0;
    const bool is_cut_after = from + kMaxShown < shown.columns.size();
    shown_text = (from > 0 ? "..." : "") + shown.Text(from, kMaxShown) +
                 (is_cut_after ? "..." : "");
    width = std::min(width, from + kMaxShown + 1 - first);
    first = first - from + (from > 0 ? 3 : 0);
  }
  std::string text =
      fmt::format("{:>{}} | {}\n", line_number, gutter, shown_text);
  text += fmt::format("{:>{}} | {:{}}{}", "", gutter, "", first,
                      std::string(width, mark));
  if (!label.empty()) text += fmt::format(" {}", Clip(label));
  return text + "\n";
}

}  // namespace

std::string Render(const Diagnostic& diagnostic, const Source& source) {
  const Position at = source.PositionOf(diagnostic.span.begin);
  int last_line = at.line;
  for (const Label& other : diagnostic.others)
    last_line = std::max(last_line, source.PositionOf(other.span.begin).line);
  const std::size_t gutter = std::to_string(last_line).size();

  std::string text =
      diagnostic.severity == Severity::kError ? "error" : "warning";
  if (!diagnostic.code.empty()) text += fmt::format("[{}]", diagnostic.code);
  text += fmt::format(": {}\n", Clip(diagnostic.message));
  text += fmt::format("{:>{}}--> {}:{}:{}\n", "", gutter, source.name(),
                      at.line, at.column);
  text += ShowPlace(source, diagnostic.span, '^', diagnostic.label, gutter);
  for (const Label& other : diagnostic.others)
    text += ShowPlace(source, other.span, '-', other.text, gutter);
  for (const std::string& note : diagnostic.notes)
    text += fmt::format("{:>{}} = note: {}\n", "", gutter, Clip(note));
  if (!diagnostic.help.empty())
    text +=
        fmt::format("{:>{}} = help: {}\n", "", gutter, Clip(diagnostic.help));
  return text;
}

std::string Render(std::vector<Diagnostic> diagnostics, const Source& source,
                   int limit) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return a.span.begin < b.span.begin;
                   });
  std::string text;
  int shown = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (limit > 0 && shown == limit) {
      text += fmt::format("... and {} more (--max-errors 0 shows all)\n",
                          diagnostics.size() - static_cast<std::size_t>(shown));
      break;
    }
    text += Render(diagnostic, source);
    ++shown;
  }
  return text;
}

}  // namespace plsc
