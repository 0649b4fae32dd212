#include "runtime/advice/lint.h"
#include "grammar/shown_line.h"

#include <fmt/format.h>

#include <iterator>
#include <ostream>
#include <vector>

#include "runtime/cli/arguments/texts.h"
#include "runtime/text/diagnostic_json.h"

namespace plsc::cli {

namespace {

// Whether the file may pass.
bool LintOne(const std::string& file, const LintCommand& command, Io& io) {
  const bool is_json = command.format == OutputFormat::kJson;
  const Result<Source> source = ReadSource(file, io);
  if (!source) {
    const Diagnostic& problem = source.diagnostics()[0];
    if (is_json)
      io.out << DiagnosticJson(problem, Source(file, "")) << '\n';
    else
      ReportUnreadable(problem, io);
    return false;
  }
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const auto compiled = CompileAllWithMap(*source, options);
  std::vector<Diagnostic> diagnostics = compiled.diagnostics();
  if (compiled) {
    std::vector<Diagnostic> more = Lint(*compiled, *source);
    std::move(more.begin(), more.end(), std::back_inserter(diagnostics));
  }
  if (is_json)
    for (const Diagnostic& diagnostic : diagnostics)
      io.out << DiagnosticJson(diagnostic, *source) << '\n';
  else
    Report(diagnostics, *source, io);
  if (!compiled) return false;
  if (!is_json)
    io.out << fmt::format("{}: {} warning{}\n", Escaped(source->name()),
                          diagnostics.size(),
                          diagnostics.size() == 1 ? "" : "s");
  return diagnostics.empty() || !command.deny;
}

}  // namespace

Exit Run(const LintCommand& command, Io& io) {
  bool all_pass = true;
  for (const std::string& file : command.files)
    all_pass = LintOne(file, command, io) && all_pass;
  return all_pass ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
