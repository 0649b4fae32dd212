#include <fmt/format.h>

#include <ostream>

#include "compiler/compile.h"
#include "grammar/shown_line.h"
#include "runtime/cli/commands.h"
#include "runtime/cli/diagnostic_json.h"
#include "runtime/cli/github_annotation.h"
#include "runtime/cli/sarif.h"
#include "runtime/lint.h"

namespace plsc::cli {

namespace {

bool UsesColor(ColorChoice choice, const Io& io) {
  return choice == ColorChoice::kAlways ||
         (choice == ColorChoice::kAuto && io.err_in_color);
}

void Show(const CheckedFile& file, const CheckCommand& command, Io& io) {
  switch (command.format) {
    case CheckFormat::kText:
      io.err << Render(
          file.diagnostics, file.source,
          RenderOptions{command.max_errors, UsesColor(command.color, io)});
      break;
    case CheckFormat::kJson:
      for (const Diagnostic& diagnostic : file.diagnostics)
        io.out << DiagnosticJson(diagnostic, file.source) << '\n';
      break;
    case CheckFormat::kGithub:
      for (const Diagnostic& diagnostic : file.diagnostics)
        io.out << GithubAnnotation(diagnostic, file.source) << '\n';
      break;
    case CheckFormat::kSarif:
      break;  // one document of all files, when all are checked
  }
}

// What is wrong with the file, or its contents in one line.
struct Checked {
  CheckedFile file;
  bool is_fine = false;
};

std::string Contents(const std::vector<MappedProgram>& programs,
                     const std::string& name) {
  std::string text;
  for (const MappedProgram& mapped : programs) {
    const Program& program = mapped.program;
    text += fmt::format(
        "{}: genotype {}, alphabet {}, {} rules, {} states, {} environments",
        name, program.genotype.name, program.genotype.alphabet->name(),
        program.genotype.rules.size(), program.genotype.states.size(),
        program.environments.size());
    if (!program.tests.empty())
      text += fmt::format(", {} tests", program.tests.size());
    text += '\n';
  }
  return text;
}

Checked CheckOne(const std::string& name, const CheckCommand& command, Io& io) {
  const Result<Source> source = ReadSource(name, io);
  const bool is_text = command.format == CheckFormat::kText;
  if (!source) {
    // There is no line to show.
    const Diagnostic& problem = source.diagnostics()[0];
    CheckedFile file{Source(name, ""), {problem}};
    if (is_text)
      io.err << fmt::format("error[{}]: {}\n", problem.code,
                            Escaped(problem.message));
    else
      Show(file, command, io);
    return {std::move(file), false};
  }
  CompileOptions options;
  options.allow_out_of_range = command.allow_range;
  const auto compiled = CompileAllWithMap(*source, options);
  CheckedFile file{*source, compiled.diagnostics()};
  if (compiled && command.lint)
    for (Diagnostic& warning : Lint(*compiled, *source))
      file.diagnostics.push_back(std::move(warning));
  Show(file, command, io);
  if (compiled && is_text)
    io.out << Contents(*compiled, Escaped(source->name()));
  return {std::move(file), static_cast<bool>(compiled)};
}

}  // namespace

Exit Run(const CheckCommand& command, Io& io) {
  const bool is_sarif = command.format == CheckFormat::kSarif;
  std::vector<CheckedFile> files;  // of SARIF only: there may be thousands
  bool all_fine = true;
  for (const std::string& name : command.files) {
    Checked checked = CheckOne(name, command, io);
    all_fine = checked.is_fine && all_fine;
    if (is_sarif && !checked.file.diagnostics.empty())
      files.push_back(std::move(checked.file));
  }
  if (is_sarif) io.out << Sarif(files);
  return all_fine ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
