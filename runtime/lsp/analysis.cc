// Everything about one version of a text, made at the first question and kept
// until the text changes. After a keystroke a client asks for diagnostics at
// once and for the rest when the user looks; most versions live for a tenth of
// a second and are never asked for more.

#include "runtime/lsp/analysis.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace plsc::lsp {

Analysis::Analysis(const std::string& uri, std::string text)
    : source_(uri, std::move(text)), lines_(source_.text()) {}

const Result<std::vector<MappedProgram>>& Analysis::compiled() {
  if (!compiled_) compiled_ = CompileAllWithMap(source_);
  return *compiled_;
}

const ast::File& Analysis::file() {
  if (!parsed_) parsed_ = Parse(source_);
  return parsed_->file;
}

const std::vector<Section>& Analysis::sections() {
  if (!sections_) sections_ = SectionsOf(file());
  return *sections_;
}

const Section& Analysis::SectionAt(std::uint32_t offset) {
  const std::vector<Section>& all = sections();
  const auto after = std::find_if(
      all.begin() + 1, all.end(),
      [&](const Section& section) { return section.begin > offset; });
  return *std::prev(after);
}

const std::vector<Mention>& Analysis::mentions() {
  if (!mentions_) mentions_ = MentionsOf(sections());
  return *mentions_;
}

const Mention* Analysis::MentionAt(std::uint32_t offset) {
  const std::vector<Mention>& all = mentions();
  const auto after = std::partition_point(
      all.begin(), all.end(),
      [&](const Mention& mention) { return mention.span.begin <= offset; });
  if (after == all.begin()) return nullptr;
  const Mention& found = *std::prev(after);
  return offset <= found.span.end ? &found : nullptr;
}

}  // namespace plsc::lsp
