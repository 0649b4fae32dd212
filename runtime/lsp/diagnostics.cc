#include "runtime/lsp/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

// LSP's DiagnosticSeverity and DiagnosticTag.
constexpr int kError = 1;
constexpr int kWarning = 2;
constexpr int kInformation = 3;
constexpr int kUnnecessary = 1;

// An editor shows one text: all that a terminal would show beside the caret.
std::string MessageOf(const Diagnostic& diagnostic) {
  std::string message = diagnostic.message;
  if (!diagnostic.label.empty())
    message += fmt::format("\n{}", diagnostic.label);
  for (const std::string& note : diagnostic.notes)
    message += fmt::format("\nnote: {}", note);
  if (!diagnostic.help.empty())
    message += fmt::format("\nhelp: {}", diagnostic.help);
  return message;
}

int SeverityOf(const Diagnostic& diagnostic, bool is_advice) {
  if (diagnostic.severity == Severity::kError) return kError;
  return is_advice ? kInformation : kWarning;
}

}  // namespace

Json DiagnosticToJson(const Diagnostic& diagnostic, const Analysis& analysis,
                      bool is_advice) {
  const LineTable& lines = analysis.lines();
  Json json = {{"range", RangeJson(lines.RangeOf(diagnostic.span))},
               {"severity", SeverityOf(diagnostic, is_advice)},
               {"source", "plsc"},
               {"message", MessageOf(diagnostic)},
               {"code", NumberOf(diagnostic.code)}};
  // What does nothing is shown faded.
  if (diagnostic.code == Code::kNotExpressed)
    json["tags"] = Json::array({kUnnecessary});
  for (const Label& other : diagnostic.others)
    json["relatedInformation"].push_back(
        {{"location",
          {{"uri", analysis.uri()},
           {"range", RangeJson(lines.RangeOf(other.span))}}},
         {"message", other.text}});
  return json;
}

Json PublishedJson(Analysis& analysis, std::int64_t version,
                   const std::vector<Diagnostic>& advice) {
  Json list = Json::array();
  const auto add = [&](const std::vector<Diagnostic>& diagnostics,
                       bool is_advice) {
    for (const Diagnostic& diagnostic : diagnostics) {
      if (list.size() >= kMaxPublished) return;
      list.push_back(DiagnosticToJson(diagnostic, analysis, is_advice));
    }
  };
  add(analysis.compiled().diagnostics(), false);
  add(advice, true);
  Json params = {{"uri", analysis.uri()}, {"version", version}};
  params["diagnostics"] = std::move(list);
  return params;
}

}  // namespace plsc::lsp
