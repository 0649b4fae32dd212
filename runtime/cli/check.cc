#include <fmt/format.h>

#include <ostream>

#include "compiler/compile.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/diagnostic_json.h"
#include "runtime/lint.h"

namespace plsc::cli {

namespace {

void Show(const std::vector<Diagnostic>& diagnostics, const Source& source,
          OutputFormat format, Io& io) {
  if (format == OutputFormat::kText) return Report(diagnostics, source, io);
  for (const Diagnostic& diagnostic : diagnostics)
    io.out << DiagnosticJson(diagnostic, source) << '\n';
}

bool CheckOne(const std::string& file, const CheckCommand& command, Io& io) {
  const Result<Source> source = ReadSource(file, io);
  if (!source) {
    const Diagnostic& problem = source.diagnostics()[0];
    if (command.format == OutputFormat::kJson)
      io.out << DiagnosticJson(problem, Source(file, "")) << '\n';
    else
      io.err << fmt::format("error[{}]: {}\n", problem.code, problem.message);
    return false;
  }
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const Result<MappedProgram> compiled = CompileWithMap(*source, options);
  std::vector<Diagnostic> diagnostics = compiled.diagnostics();
  if (compiled && command.lint)
    for (Diagnostic& warning : Lint(*compiled, *source))
      diagnostics.push_back(std::move(warning));
  Show(diagnostics, *source, command.format, io);
  if (!compiled) return false;
  const Program* program = &compiled->program;
  if (command.format == OutputFormat::kText)
    io.out << fmt::format(
        "{}: genotype {}, alphabet {}, {} rules, {} states, {} environments\n",
        source->name(), program->genotype.name,
        program->genotype.alphabet->name(), program->genotype.rules.size(),
        program->genotype.states.size(), program->environments.size());
  return true;
}

}  // namespace

Exit Run(const CheckCommand& command, Io& io) {
  bool all_fine = true;
  for (const std::string& file : command.files)
    all_fine = CheckOne(file, command, io) && all_fine;
  return all_fine ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
