// Which names must change is a question to the list of mentions. Whether they
// may is asked of the compiler: the changed text is compiled before any edit is
// handed out, since whatever makes a new name clash, in any section, is an
// error there. A list of reasons of our own would be incomplete.

#include "runtime/lsp/rename.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "grammar/keywords.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/rpc.h"

namespace plsc::lsp {

namespace {

[[noreturn]] void Refuse(const std::string& why) {
  throw Fault(ErrorCode::kRequestFailed, why);
}

// What to rename at `offset`; a Fault when that cannot be.
const Mention& Renamed(Analysis& analysis, std::uint32_t offset) {
  if (!analysis.compiled())
    Refuse("cannot rename while the file has errors: mend them first");
  const Mention* at = analysis.MentionAt(offset);
  if (at == nullptr) Refuse("expected a name to rename here");
  if (!at->is_declared())
    Refuse(fmt::format("'{}' is built in and cannot be renamed", at->name));
  return *at;
}

void CheckName(const Mention& renamed, const std::string& name) {
  const bool is_name =
      renamed.kind == NameKind::kGenotype ? IsGenotypeName(name) : IsName(name);
  if (is_name) return;
  if (IsKeyword(name)) Refuse(fmt::format("'{}' is a reserved word", name));
  Refuse(
      fmt::format("expected a name of letters, digits and '_' that does not "
                  "begin with a digit, found '{}'",
                  name));
}

// The changed text decides: whatever makes a name clash, Compile finds it.
void CheckChanged(const Analysis& analysis, const std::vector<Span>& places,
                  const std::string& name) {
  std::string changed;
  std::uint32_t copied = 0;
  for (const Span place : places) {
    changed += analysis.text().substr(copied, place.begin - copied);
    changed += name;
    copied = place.end;
  }
  changed += analysis.text().substr(copied);
  const auto compiled = CompileAll(Source(analysis.uri(), std::move(changed)));
  if (compiled) return;
  const Diagnostic& first = compiled.diagnostics()[0];
  Refuse(fmt::format("cannot rename to '{}': {}", name, first.message));
}

}  // namespace

Json PrepareRename(Analysis& analysis, std::uint32_t offset) {
  const Mention& renamed = Renamed(analysis, offset);
  return {{"range", RangeJson(analysis.lines().RangeOf(renamed.span))},
          {"placeholder", std::string(renamed.name)}};
}

Json Rename(Analysis& analysis, std::uint32_t offset, const std::string& name) {
  const Mention& renamed = Renamed(analysis, offset);
  CheckName(renamed, name);
  std::vector<Span> places;
  for (const Mention& one : analysis.mentions())
    if (NameTheSame(one, renamed)) places.push_back(one.span);
  CheckChanged(analysis, places, name);
  Json edits = Json::array();
  for (const Span place : places)
    edits.push_back(TextEditJson(analysis.lines(), place, name));
  return WorkspaceEditJson(analysis.uri(), std::move(edits));
}

}  // namespace plsc::lsp
