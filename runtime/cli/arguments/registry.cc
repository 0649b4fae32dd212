#include "runtime/cli/arguments/registry.h"

#include "runtime/cli/arguments/editors.h"
#include "runtime/cli/arguments/evaluate.h"
#include "runtime/cli/arguments/exports.h"
#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/arguments/git.h"
#include "runtime/cli/arguments/live.h"
#include "runtime/cli/arguments/pictures.h"
#include "runtime/cli/arguments/relive.h"
#include "runtime/cli/arguments/report.h"
#include "runtime/cli/arguments/robots.h"
#include "runtime/cli/arguments/runs.h"
#include "runtime/cli/arguments/shell.h"
#include "runtime/cli/arguments/study.h"
#include "runtime/cli/arguments/texts.h"
#include "runtime/cli/arguments/view.h"

namespace plsc::cli {

namespace {

template <typename... All>
Registry RegistryOf() {
  return {DeclareOne<All>...};
}

}  // namespace

const Registry& Commands() {
  static const Registry all = RegistryOf<
      CheckCommand, ExplainCommand, ExportCommand, FixCommand, FmtCommand,
      DevelopCommand, DiffCommand, DrawCommand, LintCommand, MergeCommand,
      LiveCommand, LspCommand, RegulateCommand, SimulateCommand,
      EvaluateCommand, EvolveCommand, ShowCommand, ReplayCommand, ReliveCommand,
      StudyListCommand, StudyRunCommand, StudyStatusCommand, StudyDigestCommand,
      ViewCommand, ReportCommand, WhyCommand, TestCommand, RandomCommand,
      ImportCommand, MutateCommand, CrossCommand, TrimCommand, StatsCommand,
      HashCommand, CompletionCommand, ManCommand>();
  return all;
}

}  // namespace plsc::cli
