#include "runtime/cli/commands/report_files.h"

#include <algorithm>
#include <string>

#include "runtime/cli/files/output_path.h"
#include "runtime/report/figures.h"
#include "runtime/report/tables.h"

namespace plsc::cli {

namespace {

constexpr const char* kTablesFile = "tables.md";
constexpr const char* kBoxesFile = "boxes.svg";
constexpr const char* kCurvesFile = "curves.svg";

Output OutputIn(const ReportCommand& command, const std::string& name,
                OutputKind kind) {
  const std::string separator = command.output.ends_with('/') ? "" : "/";
  return {command.output + separator + name, kind, command.force,
          command.paths};
}

}  // namespace

bool CanWriteFiles(const ReportCommand& command, Io& io) {
  if (!MakeFolder(command.output, io)) return false;
  const std::vector<Table> tables = TablesOf({}, {});
  return std::all_of(tables.begin(), tables.end(),
                     [&](const Table& table) {
                       return CanWrite(OutputIn(command, table.name + ".csv",
                                                OutputKind::kReportTable),
                                       io);
                     }) &&
         CanWrite(OutputIn(command, kTablesFile, OutputKind::kReportTables),
                  io) &&
         CanWrite(OutputIn(command, kBoxesFile, OutputKind::kSvg), io) &&
         CanWrite(OutputIn(command, kCurvesFile, OutputKind::kSvg), io);
}

bool WriteFiles(const ReportCommand& command, const StudyReport& report,
                const std::vector<ClaimResult>& claims, Io& io) {
  const std::vector<Table> tables = TablesOf(report, claims);
  return std::all_of(tables.begin(), tables.end(),
                     [&](const Table& table) {
                       return WriteOutput(OutputIn(command, table.name + ".csv",
                                                   OutputKind::kReportTable),
                                          TableCsv(table), io);
                     }) &&
         WriteOutput(OutputIn(command, kTablesFile, OutputKind::kReportTables),
                     TablesMarkdown(report, tables), io) &&
         WriteOutput(OutputIn(command, kBoxesFile, OutputKind::kSvg),
                     BoxesFigure(report), io) &&
         WriteOutput(OutputIn(command, kCurvesFile, OutputKind::kSvg),
                     CurvesFigure(report), io);
}

}  // namespace plsc::cli
