#pragma once

// The command line's parts: each function adds one command with its options
// and help, which fill the struct. Shared by the arguments_*.cc files only,
// the door to CLI11.

#include <string>

#include "runtime/cli/arguments/command.h"
#include "runtime/cli/arguments/command_description.h"

namespace CLI {
class App;
}  // namespace CLI

namespace plsc::cli {

CLI::App* AddCheck(CLI::App& app, CheckCommand& command);
CLI::App* AddCompletion(CLI::App& app, CompletionCommand& command);
CLI::App* AddCross(CLI::App& app, CrossCommand& command);
CLI::App* AddDevelop(CLI::App& app, DevelopCommand& command);
CLI::App* AddDiff(CLI::App& app, DiffCommand& command);
CLI::App* AddDraw(CLI::App& app, DrawCommand& command);
CLI::App* AddEvaluate(CLI::App& app, EvaluateCommand& command);
CLI::App* AddEvolve(CLI::App& app, EvolveCommand& command);
CLI::App* AddExplain(CLI::App& app, ExplainCommand& command);
CLI::App* AddExport(CLI::App& app, ExportCommand& command);
CLI::App* AddFix(CLI::App& app, FixCommand& command);
CLI::App* AddFmt(CLI::App& app, FmtCommand& command);
CLI::App* AddHash(CLI::App& app, HashCommand& command);
CLI::App* AddImport(CLI::App& app, ImportCommand& command);
CLI::App* AddLint(CLI::App& app, LintCommand& command);
CLI::App* AddMerge(CLI::App& app, MergeCommand& command);
CLI::App* AddMan(CLI::App& app, ManCommand& command);
CLI::App* AddMutate(CLI::App& app, MutateCommand& command);
CLI::App* AddLsp(CLI::App& app, LspCommand& command);
CLI::App* AddRandom(CLI::App& app, RandomCommand& command);
CLI::App* AddReplay(CLI::App& app, ReplayCommand& command);
CLI::App* AddReport(CLI::App& app, ReportCommand& command);
CLI::App* AddShow(CLI::App& app, ShowCommand& command);
CLI::App* AddRegulate(CLI::App& app, RegulateCommand& command);
CLI::App* AddSimulate(CLI::App& app, SimulateCommand& command);
CLI::App* AddStats(CLI::App& app, StatsCommand& command);
/// `plsc study` itself, which has commands of its own.
CLI::App* AddStudy(CLI::App& app);
CLI::App* AddStudyList(CLI::App& study, StudyListCommand& command);
CLI::App* AddStudyRun(CLI::App& study, StudyRunCommand& command);
CLI::App* AddStudyStatus(CLI::App& study, StudyStatusCommand& command);
CLI::App* AddTest(CLI::App& app, TestCommand& command);
CLI::App* AddTrim(CLI::App& app, TrimCommand& command);
CLI::App* AddView(CLI::App& app, ViewCommand& command);
CLI::App* AddWhy(CLI::App& app, WhyCommand& command);

/// The command and all below it; `name` as in CommandDescription.
CommandDescription DescribeApp(const CLI::App& app, const std::string& name);

/// --force, of every command that writes files.
void AddForce(CLI::App* command, bool& force);

/// --format text|json; `json` says what a line of it is.
void AddFormat(CLI::App* command, OutputFormat& format, const char* json);

}  // namespace plsc::cli
