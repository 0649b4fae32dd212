#include "runtime/lsp/formatting.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/compile.h"
#include "compiler/format.h"
#include "grammar/parse.h"
#include "runtime/lsp/text_edits.h"
#include "runtime/text/unified_diff.h"

namespace plsc::lsp {

namespace {

std::vector<std::string_view> SortedComments(const ast::File& file) {
  std::vector<std::string_view> comments;
  for (const Span comment : file.comments) {
    std::string_view text = file.Text(comment);
    comments.push_back(text.substr(0, text.find_last_not_of(" \t\r") + 1));
  }
  std::sort(comments.begin(), comments.end());
  return comments;
}

// Whether the text still says the same, with the same comments: an item that
// moves is a change here and another one elsewhere.
bool SaysTheSame(const Source& before, const Source& after) {
  const auto programs = CompileAll(before);
  const auto changed = CompileAll(after);
  return programs && changed && *programs == *changed &&
         SortedComments(Parse(before).file) ==
             SortedComments(Parse(after).file);
}

}  // namespace

Json FormattingEdits(const Analysis& analysis) {
  const Result<std::string> formatted = Format(analysis.source());
  if (!formatted) return nullptr;
  return EditsTo(analysis, *formatted);
}

Json FormattingEdits(const Analysis& analysis, std::uint32_t first,
                     std::uint32_t last) {
  const Source& source = analysis.source();
  const Result<std::string> formatted = Format(source);
  if (!formatted) return nullptr;
  std::string changed;
  std::size_t copied = 0;
  for (const ChangedLines& one : LineChanges(source.text(), *formatted)) {
    // Lines that are only inserted stand before the line that they precede.
    const bool is_wanted =
        one.first_line <= last && std::max(one.end_line, one.first_line + 1) >
                                      static_cast<std::size_t>(first);
    if (!is_wanted) continue;
    changed += source.text().substr(copied, one.begin - copied);
    changed += one.replacement;
    copied = one.end;
  }
  changed += source.text().substr(copied);
  if (!SaysTheSame(source, Source(source.name(), changed))) return nullptr;
  return EditsTo(analysis, changed);
}

}  // namespace plsc::lsp
