#include "runtime/lsp/code_actions.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "compiler/apply_fixes.h"
#include "grammar/shown_line.h"
#include "runtime/lsp/diagnostics.h"
#include "runtime/lsp/params.h"
#include "runtime/lsp/text_edits.h"

namespace plsc::lsp {

namespace {

constexpr const char* kQuickFix = "quickfix";
constexpr const char* kFixAll = "source.fixAll.plsc";

// A kind asks for itself and for those below it: `source` for `source.fixAll`.
bool Wants(const Json& only, std::string_view kind) {
  if (!only.is_array() || only.empty()) return true;
  return std::any_of(only.begin(), only.end(), [&](const Json& asked) {
    if (!asked.is_string()) return false;
    const auto& name = asked.get_ref<const std::string&>();
    return kind == name || (kind.starts_with(name) &&
                            kind.substr(name.size()).starts_with('.'));
  });
}

std::string Quoted(std::string_view text) {
  // Characters of a title that stay readable in a menu.
  constexpr std::size_t kMaxShown = 40;
  std::string shown(text);
  std::replace(shown.begin(), shown.end(), '\n', ' ');
  while (shown.starts_with(' ')) shown.erase(0, 1);
  return "'" + Printable(shown, kMaxShown) + "'";
}

std::string TitleOf(const Fix& fix, std::string_view text) {
  const std::string_view removed =
      text.substr(fix.span.begin, fix.span.end - fix.span.begin);
  if (removed.empty()) return "Insert " + Quoted(fix.replacement);
  if (fix.replacement.empty()) return "Remove " + Quoted(removed);
  return fmt::format("Replace {} by {}", Quoted(removed),
                     Quoted(fix.replacement));
}

bool Touches(Span a, Span b) {
  return a.begin <= b.end && b.begin <= a.end;
}

class Finder {
 public:
  Finder(Analysis& analysis, Span range) : analysis_(analysis), range_(range) {}

  void AddFixesOf(const Diagnostic& diagnostic, bool is_advice) {
    if (!Touches(diagnostic.span, range_)) return;
    if (!diagnostic.fixes.empty()) AddFix(diagnostic, is_advice);
    if (diagnostic.severity == Severity::kWarning && is_advice)
      AddAllow(diagnostic);
  }

  void AddFixAll() {
    const MendedText mended = MendText(analysis_.source());
    if (mended.made.empty()) return;
    Json action = {{"title", "Fix all that plsc can mend"}, {"kind", kFixAll}};
    action["edit"] =
        WorkspaceEditJson(analysis_.uri(), EditsTo(analysis_, mended.text));
    actions_.push_back(std::move(action));
  }

  Json Take() { return std::move(actions_); }

 private:
  Json& Add(std::string title, const Diagnostic& diagnostic, bool is_advice) {
    Json action = {{"title", std::move(title)}, {"kind", kQuickFix}};
    action["diagnostics"].push_back(
        DiagnosticToJson(diagnostic, analysis_, is_advice));
    return actions_.emplace_back(std::move(action));
  }

  void AddFix(const Diagnostic& diagnostic, bool is_advice) {
    Json edits = Json::array();
    for (const Fix& fix : diagnostic.fixes)
      edits.push_back(
          TextEditJson(analysis_.lines(), fix.span, fix.replacement));
    Json& action = Add(TitleOf(diagnostic.fixes[0], analysis_.text()),
                       diagnostic, is_advice);
    action["isPreferred"] = true;
    action["edit"] = WorkspaceEditJson(analysis_.uri(), std::move(edits));
  }

  // A comment of its own line before the item.
  void AddAllow(const Diagnostic& diagnostic) {
    const auto& items = analysis_.file().items;
    const auto item =
        std::find_if(items.begin(), items.end(), [&](const ast::Item& one) {
          return one.span.begin <= diagnostic.span.begin &&
                 diagnostic.span.begin < one.span.end;
        });
    if (item == items.end()) return;
    // Behind another item on its line the comment would belong to that one.
    const std::uint32_t begin = item->span.begin;
    const std::string_view text = analysis_.text();
    const std::size_t blank = text.substr(0, begin).find_last_not_of(" \t");
    const bool is_first_on_line =
        blank == std::string_view::npos || text[blank] == '\n';
    Json& action = Add(fmt::format("Allow {} here", NumberOf(diagnostic.code)),
                       diagnostic, true);
    action["edit"] = WorkspaceEditJson(
        analysis_.uri(),
        Json::array({TextEditJson(
            analysis_.lines(), {begin, begin},
            fmt::format("{}# plsc: allow {}\n", is_first_on_line ? "" : "\n",
                        NumberOf(diagnostic.code)))}));
  }

  Analysis& analysis_;
  Span range_;
  Json actions_ = Json::array();
};

}  // namespace

Json CodeActions(Analysis& analysis, const std::vector<Diagnostic>& advice,
                 const Json& params) {
  const PlaceRange range = ReadRange(params, "range");
  const LineTable& lines = analysis.lines();
  Finder finder(analysis,
                {lines.OffsetAt(range.start), lines.OffsetAt(range.end)});
  Json only;
  const auto context = params.find("context");
  if (context != params.end() && context->is_object() &&
      context->contains("only"))
    only = (*context)["only"];
  if (Wants(only, kQuickFix)) {
    for (const Diagnostic& one : analysis.compiled().diagnostics())
      finder.AddFixesOf(one, false);
    for (const Diagnostic& one : advice) finder.AddFixesOf(one, true);
  }
  if (Wants(only, kFixAll)) finder.AddFixAll();
  return finder.Take();
}

}  // namespace plsc::lsp
