#include "runtime/cli/diagnostics/github_annotation.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/shown_line.h"

namespace plsc::cli {

namespace {

// Characters of a message; they quote names, which may be megabytes long.
constexpr std::size_t kMaxMessage = 400;

// What a workflow command would take for its own syntax, as `escaped` names
// it: '%' first, then line ends, and ':' and ',' between properties.
std::string Escape(std::string_view text, std::string_view escaped) {
  std::string result;
  for (const char c : text) {
    if (escaped.find(c) != std::string_view::npos)
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      result += c;
  }
  return result;
}

std::string Data(std::string_view text) {
  return Escape(text, "%\r\n");
}

std::string Property(std::string_view text) {
  return Escape(text, "%\r\n:,");
}

std::string Clip(std::string_view text) {
  return Printable(text, kMaxMessage);
}

std::string ClippedMessage(const Diagnostic& diagnostic) {
  std::string text = Clip(diagnostic.message);
  if (!diagnostic.label.empty()) text += "\n" + Clip(diagnostic.label);
  for (const std::string& note : diagnostic.notes)
    text += "\nnote: " + Clip(note);
  if (!diagnostic.help.empty()) text += "\nhelp: " + Clip(diagnostic.help);
  return text;
}

}  // namespace

std::string GithubAnnotation(const Diagnostic& diagnostic,
                             const Source& source) {
  const Position begin = source.PositionOf(diagnostic.span.begin);
  const Position end =
      source.PositionOf(std::max(diagnostic.span.begin, diagnostic.span.end));
  std::string text =
      fmt::format("::{} file={},line={},col={},endLine={}",
                  diagnostic.severity == Severity::kError ? "error" : "warning",
                  Property(source.name()), begin.line, begin.column, end.line);
  // Columns only mean something to GitHub within one line.
  if (begin.line == end.line) text += fmt::format(",endColumn={}", end.column);
  return text + fmt::format(",title={}::{}", NumberOf(diagnostic.code),
                            Data(ClippedMessage(diagnostic)));
}

}  // namespace plsc::cli
