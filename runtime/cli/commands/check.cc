#include <ostream>

#include "runtime/cli/arguments/texts.h"
#include "runtime/cli/commands/check_file.h"
#include "runtime/cli/diagnostics/github_annotation.h"
#include "runtime/cli/diagnostics/sarif.h"
#include "runtime/text/diagnostic_json.h"

namespace plsc::cli {

namespace {

bool UsesColor(ColorChoice choice, const Io& io) {
  return choice == ColorChoice::kAlways ||
         (choice == ColorChoice::kAuto && io.err_in_color);
}

void Report(const CheckedFile& file, const CheckCommand& command, Io& io) {
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

FileCheck CheckOne(const std::string& name, const CheckCommand& command,
                   Io& io) {
  const Result<Source> source = ReadSource(name, io);
  const bool is_text = command.format == CheckFormat::kText;
  if (!source) {
    const Diagnostic& problem = source.diagnostics()[0];
    CheckedFile file{Source(name, ""), {problem}};
    if (is_text)
      ReportUnreadable(problem, io);
    else
      Report(file, command, io);
    return {{std::move(file)}, false, ""};
  }
  FileCheck check = CheckFile(*source, command, io);
  for (const CheckedFile& file : check.findings) Report(file, command, io);
  if (is_text) io.out << check.contents;
  return check;
}

}  // namespace

Exit Run(const CheckCommand& command, Io& io) {
  const bool is_sarif = command.format == CheckFormat::kSarif;
  std::vector<CheckedFile> files;  // of SARIF only: there may be thousands
  bool all_fine = true;
  for (const std::string& name : command.files) {
    FileCheck check = CheckOne(name, command, io);
    all_fine = check.is_fine && all_fine;
    if (!is_sarif) continue;
    for (CheckedFile& file : check.findings)
      if (!file.diagnostics.empty()) files.push_back(std::move(file));
  }
  if (is_sarif) io.out << Sarif(files);
  return all_fine ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
