#include "grammar/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace plsc {

namespace {

constexpr int kTabWidth = 4;  // columns of a tab in a shown line
// Longest shown line in characters; a minified file must not flood a terminal.
constexpr std::size_t kMaxShown = 160;

bool IsContinuation(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

// Longest message, label, note or help that is shown in full, in bytes: they
// quote names, and a hostile name could be megabytes long.
constexpr std::size_t kMaxMessage = 400;

std::string Clip(std::string_view text) {
  if (text.size() <= kMaxMessage) return std::string(text);
  std::size_t end = kMaxMessage;
  while (end > 0 && IsContinuation(text[end])) --end;
  return std::string(text.substr(0, end)) + "...";
}

// A line as it is shown, and where its bytes went: tabs become blanks,
// control characters and bytes that are not UTF-8 become '?', so that a
// hostile file cannot drive the terminal.
struct ShownLine {
  std::string text;
  std::vector<int> column_of_byte;  // one more than the line has bytes
};

int SequenceLength(std::string_view line, std::size_t i) {
  const auto lead = static_cast<unsigned char>(line[i]);
  const int length = lead < 0x80             ? 1
                     : (lead & 0xE0) == 0xC0 ? 2
                     : (lead & 0xF0) == 0xE0 ? 3
                     : (lead & 0xF8) == 0xF0 ? 4
                                             : 0;
  if (length == 0 || i + static_cast<std::size_t>(length) > line.size())
    return 0;
  for (int k = 1; k < length; ++k)
    if (!IsContinuation(line[i + static_cast<std::size_t>(k)])) return 0;
  return length;
}

ShownLine Show(std::string_view line) {
  ShownLine shown;
  int column = 0;
  for (std::size_t i = 0; i < line.size();) {
    const int length = SequenceLength(line, i);
    const char c = line[i];
    if (c == '\t') {
      const int blanks = kTabWidth - column % kTabWidth;
      shown.text.append(static_cast<std::size_t>(blanks), ' ');
      shown.column_of_byte.push_back(column);
      column += blanks;
      ++i;
      continue;
    }
    const bool is_control = length == 1 && (c < ' ' || c == 0x7F);
    const int bytes = std::max(length, 1);
    if (length == 0 || is_control)
      shown.text += '?';
    else
      shown.text.append(line.substr(i, static_cast<std::size_t>(bytes)));
    for (int k = 0; k < bytes; ++k) shown.column_of_byte.push_back(column);
    ++column;
    i += static_cast<std::size_t>(bytes);
  }
  shown.column_of_byte.push_back(column);
  return shown;
}

// One source line with `mark` repeated under the bytes of `span`.
std::string ShowPlace(const Source& source, Span span, char mark,
                      std::string_view label, std::size_t gutter) {
  const int line_number = source.PositionOf(span.begin).line;
  const std::string_view line = source.Line(line_number);
  const std::uint32_t line_begin = source.LineBegin(line_number);
  ShownLine shown = Show(line);
  const auto column_at = [&](std::uint32_t offset) {
    const std::size_t byte =
        std::min<std::size_t>(offset - line_begin, line.size());
    return static_cast<std::size_t>(shown.column_of_byte[byte]);
  };
  std::size_t first = column_at(span.begin);
  const std::size_t last = column_at(std::max(span.end, span.begin));
  std::size_t width = last > first ? last - first : 1;
  if (shown.text.size() > kMaxShown) {
    // Cut bytes, not characters, only when all are one byte; else keep.
    const std::size_t from = first > kMaxShown / 2 ? first - kMaxShown / 2 : 0;
    if (std::none_of(shown.text.begin(), shown.text.end(), IsContinuation)) {
      shown.text = (from > 0 ? "..." : "") +
                   shown.text.substr(from, kMaxShown) +
                   (from + kMaxShown < shown.text.size() ? "..." : "");
      first = first - from + (from > 0 ? 3 : 0);
      width = std::min(width, shown.text.size() + 1 - first);
    }
  }
  std::string text =
      fmt::format("{:>{}} | {}\n", line_number, gutter, shown.text);
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
