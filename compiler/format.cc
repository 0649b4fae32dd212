// A formatter may not change what a file means, and this one does not trust
// itself: what it wrote is compiled and compared with what was given, comments
// are counted, and it is formatted once more to see that nothing moves. Where
// one of these fails the file stays as it is and the defect is reported as
// ours. It doubles the work; files that people write take milliseconds.

#include "compiler/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/layout.h"
#include "grammar/parse.h"

namespace plsc {

namespace {

std::vector<std::string> SortedComments(const ast::File& file) {
  std::vector<std::string> comments;
  comments.reserve(file.comments.size());
  for (const Span span : file.comments) {
    const std::string_view text = file.Text(span);
    comments.emplace_back(text.substr(0, text.find_last_not_of(" \t\r") + 1));
  }
  std::sort(comments.begin(), comments.end());
  return comments;
}

Diagnostic Defect(std::string_view what) {
  return Diagnostic(
             Code::kFormatterDefect, {},
             fmt::format("the formatted text {}; the file is left as it is",
                         what))
      .WithHelp("this is a defect of plsc; please report it with the file");
}

}  // namespace

Result<std::string> Format(const Source& source, const FormatOptions& options) {
  const Result<std::vector<Program>> programs =
      CompileAll(source, options.compile);
  if (!programs) return programs.diagnostics();
  std::vector<AlphabetPtr> alphabets;
  for (const Program& program : *programs)
    alphabets.push_back(program.genotype.alphabet);
  const ParseResult parsed = Parse(source);
  std::string text = Layout(parsed.file, alphabets, options.compact);

  const Source formatted(source.name(), text);
  const Result<std::vector<Program>> again =
      CompileAll(formatted, options.compile);
  if (!again || !(*again == *programs))
    return Defect("does not mean the same as the file");
  const ParseResult reparsed = Parse(formatted);
  if (SortedComments(reparsed.file) != SortedComments(parsed.file))
    return Defect("does not have the same comments");
  if (Layout(reparsed.file, alphabets, options.compact) != text)
    return Defect("would change when formatted again");
  return {WithLineEndsOf(source.text(), std::move(text)),
          programs.diagnostics()};
}

}  // namespace plsc
