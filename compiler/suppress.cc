// Comments that give orders. What an order is about is an item, found by the
// rule by which the formatter decides where a comment goes (layout.h): with
// another rule formatting a file would move a warning out from under the
// comment that silences it. Items do not overlap and stand in order, so a
// binary search finds the neighbours of a comment.
//
// A diagnostic is silenced if its begin lies in an item whose comments allow
// its code. Only codes of warnings are accepted; an error that could be
// silenced would let a broken genotype through. Orders that do nothing (no
// item, no such code) are warned of, as their writer believes in them.

#include "compiler/suppress.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "compiler/limits.h"
#include "grammar/codes.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

constexpr std::string_view kMark = "plsc:";
constexpr std::string_view kAllow = "allow";
constexpr std::string_view kAllowFile = "allow-file";

bool IsSeparator(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == ',';
}

// The words of `span`.
std::vector<Span> WordsOf(const ast::File& file, Span span) {
  std::vector<Span> words;
  for (std::uint32_t at = span.begin; at < span.end;) {
    while (at < span.end && IsSeparator(file.text[at])) ++at;
    const std::uint32_t begin = at;
    while (at < span.end && !IsSeparator(file.text[at])) ++at;
    if (at > begin) words.push_back({begin, at});
  }
  return words;
}

// What follows "# plsc:", or nothing when the comment is for people.
std::optional<Span> InstructionOf(const ast::File& file, Span comment) {
  std::uint32_t at = comment.begin + 1;
  while (at < comment.end && IsSeparator(file.text[at])) ++at;
  if (!file.Text({at, comment.end}).starts_with(kMark)) return std::nullopt;
  return Span{at + static_cast<std::uint32_t>(kMark.size()), comment.end};
}

// The item that the comment belongs to, by the formatter's rule
// (compiler/layout.h); nothing before the version line and after the last
// item.
std::optional<Span> ItemOf(const ast::File& file, Span comment) {
  if (comment.begin < file.version.begin) return std::nullopt;
  const auto next = std::partition_point(
      file.items.begin(), file.items.end(),
      [&](const ast::Item& item) { return item.span.end <= comment.begin; });
  if (next != file.items.end() && next->span.begin < comment.begin)
    return next->span;
  if (next != file.items.begin()) {
    const Span before = std::prev(next)->span;
    const std::string_view between = file.Text({before.end, comment.begin});
    if (between.find('\n') == std::string_view::npos) return before;
  }
  if (next == file.items.end()) return std::nullopt;
  return next->span;
}

}  // namespace

Suppressions::Suppressions(const ast::File& file) {
  for (const Span comment : file.comments) {
    if (!reporter_.Takes(Severity::kWarning)) return;
    Read(file, comment);
  }
}

void Suppressions::Warn(Span span, std::string message, std::string help) {
  reporter_.Report(Code::kWrongAllow, span, std::move(message))
      .WithHelp(std::move(help));
}

void Suppressions::Read(const ast::File& file, Span comment) {
  const std::optional<Span> instruction = InstructionOf(file, comment);
  if (!instruction) return;
  const std::vector<Span> words = WordsOf(file, *instruction);
  if (words.empty()) {
    Warn(comment, "expected 'allow' or 'allow-file' after '# plsc:'", "");
    return;
  }
  const std::string_view verb = file.Text(words[0]);
  if (verb != kAllow && verb != kAllowFile) {
    Warn(words[0],
         fmt::format("expected 'allow' or 'allow-file', found '{}'", verb),
         "a comment that starts with '# plsc:' is for plsc");
    return;
  }
  const std::span<const Span> codes = std::span(words).subspan(1);
  if (codes.empty()) {
    Warn(words[0], fmt::format("expected a code after '{}'", verb),
         fmt::format("such as '# plsc: {} W3002'", verb));
    return;
  }
  ReadCodes(file, codes, verb == kAllowFile);
}

void Suppressions::ReadCodes(const ast::File& file, std::span<const Span> words,
                             bool is_for_file) {
  // All of the file, also what is reported at its end.
  std::optional<Span> where =
      Span{0, std::numeric_limits<std::uint32_t>::max()};
  if (!is_for_file) where = ItemOf(file, words[0]);
  if (!where) {
    Warn(words[0], "this 'allow' belongs to no item",
         "for the whole file write '# plsc: allow-file'");
    return;
  }
  for (const Span word : words) {
    const std::string_view number = file.Text(word);
    const std::optional<Code> code = FindCode(number);
    if (!code) {
      std::vector<std::string_view> known;
      for (const CodeInfo& info : DiagnosticCodes())
        if (info.number.starts_with('W')) known.push_back(info.number);
      const auto nearest = Suggest(number, known);
      Warn(word, fmt::format("there is no warning '{}'", number),
           nearest ? fmt::format("did you mean '{}'?", *nearest)
                   : "'plsc explain' lists the codes");
      return;  // what follows is likely a remark, not codes
    }
    if (!number.starts_with('W')) {
      Warn(word, fmt::format("{} is an error, which cannot be allowed", number),
           "");
      continue;
    }
    allowed_.push_back({*code, *where});
  }
}

bool Suppressions::Allows(Code code, Span place) const {
  return std::any_of(
      allowed_.begin(), allowed_.end(), [&](const Allowed& allowed) {
        return allowed.code == code && allowed.where.begin <= place.begin &&
               place.begin < allowed.where.end;
      });
}

std::vector<Diagnostic> Suppressions::Keep(
    std::vector<Diagnostic> diagnostics) const {
  std::erase_if(diagnostics, [&](const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::kWarning &&
           Allows(diagnostic.code, diagnostic.span);
  });
  return diagnostics;
}

}  // namespace plsc
