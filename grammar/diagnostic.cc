// One structure rendered for people. Whatever is quoted from a text is bounded
// in length and made printable, since names may be megabytes and bytes may be
// escape sequences; of a long line only the part around the place is looked at,
// so that a thousand reports in one line cost a thousand parts. Diagnostics are
// sorted by place, stably: of those at one place the stage that ran first comes
// first.

#include "grammar/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grammar/shown_line.h"
#include "grammar/utf8.h"

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

// Select Graphic Rendition of ECMA-48: bold, and the colours that terminals
// show on dark and on light ground alike.
constexpr std::string_view kBold = "1";
constexpr std::string_view kRed = "1;31";
constexpr std::string_view kYellow = "1;33";
constexpr std::string_view kBlue = "1;34";

// What paints texts, or leaves them as they are.
struct Painter {
  bool in_color = false;

  std::string operator()(std::string_view ink, std::string_view text) const {
    if (!in_color || text.empty()) return std::string(text);
    return fmt::format("\033[{}m{}\033[0m", ink, text);
  }
};

// A place that is shown: what is under it, and how.
struct Place {
  Span span;
  char mark;
  std::string_view label;
  std::string_view ink;
};

// Of a longer line only so many bytes around a place are looked at: several
// times what is shown, whatever the characters.
constexpr std::size_t kMaxLooked = 16 * kMaxShown;

// The part of a line around `at`, cut between characters.
struct LinePart {
  std::string_view text;
  std::uint32_t begin = 0;  ///< of the part in the source
};

LinePart PartOf(std::string_view line, std::uint32_t line_begin,
                std::uint32_t at) {
  if (line.size() <= 2 * kMaxLooked) return {line, line_begin};
  const auto is_inside = [&](std::size_t i) {
    return i < line.size() && GoesOn(line[i]);
  };
  const std::size_t middle =
      std::min<std::size_t>(at - line_begin, line.size());
  std::size_t begin = middle > kMaxLooked ? middle - kMaxLooked : 0;
  std::size_t end = std::min(middle + kMaxLooked, line.size());
  while (is_inside(begin)) ++begin;
  while (is_inside(end)) ++end;
  return {line.substr(begin, end - begin),
          line_begin + static_cast<std::uint32_t>(begin)};
}

// One source line with the mark repeated under the bytes of the place.
std::string RenderPlace(const Source& source, const Place& place,
                        std::size_t gutter, const Painter& paint) {
  const Span span = place.span;
  const int line_number = source.PositionOf(span.begin).line;
  const LinePart part = PartOf(source.Line(line_number),
                               source.LineBegin(line_number), span.begin);
  const ShownLine shown = ShownLineOf(part.text);
  const auto column_at = [&](std::uint32_t offset) {
    return shown.column_of_byte[std::min<std::size_t>(offset - part.begin,
                                                      part.text.size())];
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
      paint(kBlue, fmt::format("{:>{}} | ", line_number, gutter)) + shown_text +
      "\n" + paint(kBlue, fmt::format("{:>{}} | ", "", gutter)) +
      std::string(first, ' ');
  std::string marks(width, place.mark);
  if (!place.label.empty()) marks += " " + Clip(place.label);
  return text + paint(place.ink, marks) + "\n";
}

std::string RenderPlaceAndName(const Source& source, const Place& place,
                               std::size_t gutter, const Painter& paint) {
  const Position at = source.PositionOf(place.span.begin);
  return paint(kBlue, fmt::format("{:>{}}--> ", "", gutter)) +
         fmt::format("{}:{}:{}\n", Escaped(source.name()), at.line, at.column) +
         RenderPlace(source, place, gutter, paint);
}

// What is not shown, of `total` that were found and `shown` that are.
std::string Rest(std::size_t total, std::size_t shown) {
  const bool is_all = total < kMaxReported;
  if (shown < total)
    return fmt::format("... and {}{} more (--max-errors 0 shows {})\n",
                       is_all ? "" : "at least ", total - shown,
                       is_all ? "all" : fmt::format("{}", total));
  if (is_all) return "";
  return "... and perhaps more: the search ends here\n";
}

}  // namespace

Diagnostic::Diagnostic(Code of, Span place, std::string headline)
    : severity(NumberOf(of).starts_with('W') ? Severity::kWarning
                                             : Severity::kError),
      code(of),
      span(place),
      message(std::move(headline)) {}

Diagnostic& Diagnostic::WithLabel(std::string text) {
  label = std::move(text);
  return *this;
}

Diagnostic& Diagnostic::WithOther(Span place, std::string text) {
  others.push_back({place, std::move(text)});
  return *this;
}

Diagnostic& Diagnostic::WithNote(std::string text) {
  notes.push_back(std::move(text));
  return *this;
}

Diagnostic& Diagnostic::WithHelp(std::string text) {
  help = std::move(text);
  return *this;
}

Diagnostic& Diagnostic::WithFix(Span place, std::string replacement) {
  fixes.push_back({place, std::move(replacement)});
  return *this;
}

bool HasErrors(const std::vector<Diagnostic>& diagnostics) {
  return std::any_of(
      diagnostics.begin(), diagnostics.end(),
      [](const Diagnostic& d) { return d.severity == Severity::kError; });
}

void SortAndDropRepeated(std::vector<Diagnostic>* diagnostics) {
  std::stable_sort(diagnostics->begin(), diagnostics->end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return a.span.begin < b.span.begin;
                   });
  std::vector<Diagnostic> kept;
  kept.reserve(diagnostics->size());
  for (Diagnostic& diagnostic : *diagnostics) {
    bool is_repeated = false;
    for (auto known = kept.rbegin();
         known != kept.rend() && known->span.begin == diagnostic.span.begin &&
         !is_repeated;
         ++known)
      is_repeated = known->code == diagnostic.code &&
                    known->span.end == diagnostic.span.end &&
                    known->message == diagnostic.message;
    if (!is_repeated) kept.push_back(std::move(diagnostic));
  }
  *diagnostics = std::move(kept);
}

std::string Render(const Diagnostic& diagnostic, const Source& source,
                   bool in_color) {
  const Painter paint{in_color};
  int last_line = source.PositionOf(diagnostic.span.begin).line;
  for (const Label& other : diagnostic.others)
    last_line = std::max(last_line, source.PositionOf(other.span.begin).line);
  const std::size_t gutter = std::to_string(last_line).size();
  const bool is_error = diagnostic.severity == Severity::kError;
  const std::string_view ink = is_error ? kRed : kYellow;

  const std::string kind = fmt::format("{}[{}]", is_error ? "error" : "warning",
                                       NumberOf(diagnostic.code));
  std::string text =
      paint(ink, kind) + paint(kBold, ": " + Clip(diagnostic.message)) + "\n";
  text += RenderPlaceAndName(
      source, {diagnostic.span, '^', diagnostic.label, ink}, gutter, paint);
  for (const Label& other : diagnostic.others)
    text += RenderPlace(source, {other.span, '-', other.text, kBlue}, gutter,
                        paint);
  const std::string mark = paint(kBlue, fmt::format("{:>{}} = ", "", gutter));
  for (const std::string& note : diagnostic.notes)
    text += mark + paint(kBold, "note") + ": " + Clip(note) + "\n";
  if (!diagnostic.help.empty())
    text += mark + paint(kBold, "help") + ": " + Clip(diagnostic.help) + "\n";
  return text;
}

std::string RenderPlace(Span span, const std::string& label,
                        const Source& source) {
  const std::size_t gutter =
      std::to_string(source.PositionOf(span.begin).line).size();
  return RenderPlaceAndName(source, {span, '^', label, kRed}, gutter, {});
}

std::string Render(std::vector<Diagnostic> diagnostics, const Source& source,
                   const RenderOptions& options) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return a.span.begin < b.span.begin;
                   });
  std::string text;
  std::size_t shown = diagnostics.size();
  if (options.limit > 0)
    shown = std::min(shown, static_cast<std::size_t>(options.limit));
  for (std::size_t i = 0; i < shown; ++i)
    text += Render(diagnostics[i], source, options.in_color);
  return text + Rest(diagnostics.size(), shown);
}

std::string Render(std::vector<Diagnostic> diagnostics, const Source& source,
                   int limit) {
  return Render(std::move(diagnostics), source, RenderOptions{limit, false});
}

}  // namespace plsc
