// Every table has the study and whose values its rows are of first, so that
// tables of several reports can be joined, and a file of ours be told from
// another. What is not known is an empty cell.

#include "runtime/report/tables.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "grammar/number.h"
#include "runtime/report/comparison.h"
#include "runtime/report/swaps.h"
#include "runtime/text/csv_cell.h"

namespace plsc {

namespace {

using CellRow = std::vector<std::string>;

constexpr int kDigits = 6;

std::string NumberCell(double value) {
  return std::isfinite(value) ? PrintRoundedNumber(value, kDigits) : "";
}

std::string NumberCell(const std::optional<double>& value) {
  return value ? NumberCell(*value) : "";
}

std::string CellAt(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? NumberCell(values[i]) : "";
}

std::string RunsAt(const ClaimFinding& finding, std::size_t i) {
  return i < finding.runs.size() ? std::to_string(finding.runs[i]) : "";
}

std::string TitleWithUnit(const ReportMeasure& measure) {
  return measure.unit.empty()
             ? measure.title
             : fmt::format("{} ({})", measure.title, measure.unit);
}

CellRow RowOfFinding(const StudyReport& report, const ClaimResult& result,
                     Told told) {
  const Claim& claim = result.stated.claim;
  const StudyClaims& study = report.claims[result.study];
  const ClaimsVersion& version = study.record[result.stated.since];
  const ClaimFinding& finding =
      told == Told::kRelived ? *result.relived : result.recorded;
  const std::optional<ReportMeasure> measure = MeasureOf(report, claim);
  std::optional<Interval> interval = finding.interval;
  if (finding.effect) interval = finding.effect->interval;
  const bool is_first = (told == Told::kRelived) == result.IsRelivedFirst();
  const auto limit = [&](double Interval::*end) {
    return interval ? NumberCell((*interval).*end) : "";
  };
  return {study.study,
          std::string(NameIn(kToldNames, told)),
          claim.name,
          std::string(NameIn(kVerdictNames, finding.verdict)),
          is_first ? "yes" : "no",
          measure ? TitleWithUnit(*measure) : claim.measure,
          std::string(NameIn(kClaimOfNames, claim.of)),
          WhatIsClaimed(claim),
          RunsAt(finding, 0),
          RunsAt(finding, 1),
          CellAt(finding.medians, 0),
          CellAt(finding.medians, 1),
          NumberCell(finding.ratio),
          finding.effect ? NumberCell(finding.effect->a) : "",
          NumberCell(finding.ours),
          finding.minimum ? std::to_string(*finding.minimum) : "",
          limit(&Interval::low),
          limit(&Interval::high),
          NumberCell(finding.p),
          NumberCell(finding.holm),
          finding.holm ? std::to_string(result.family) : "",
          result.stated.withdrawn ? "withdrawn" : "",
          version.stated,
          version.hash,
          claim.source};
}

Table ClaimsTable(const StudyReport& report,
                  const std::vector<ClaimResult>& claims) {
  Table table{"claims",
              "Claims",
              {"study",
               "values",
               "claim",
               "verdict",
               "told first",
               "measure",
               "of",
               "says",
               "first runs",
               "second runs",
               "first median",
               "second median",
               "ratio",
               "A",
               "ours",
               "minimum",
               "low",
               "high",
               "p",
               "p by Holm",
               "corrected among",
               "withdrawn",
               "stated",
               "hash",
               "source"},
              {}};
  for (const ClaimResult& result : claims) {
    const bool is_relived_first = result.IsRelivedFirst();
    const auto add = [&](Told told) {
      if (told == Told::kRecorded || result.relived)
        table.rows.push_back(RowOfFinding(report, result, told));
    };
    add(is_relived_first ? Told::kRelived : Told::kRecorded);
    add(is_relived_first ? Told::kRecorded : Told::kRelived);
  }
  return table;
}

std::vector<Finals> AllFinals(const StudyReport& report) {
  std::vector<Finals> all;
  for (const Counted of : {Counted::kMean, Counted::kBest})
    for (const Told told : {Told::kRelived, Told::kRecorded})
      for (Finals& one : FinalsOf(report, of, told))
        all.push_back(std::move(one));
  return all;
}

std::string OfName(Counted of) {
  return of == Counted::kMean ? "mean" : "best";
}

Table BoxesTable(const StudyReport& report, const std::vector<Finals>& all) {
  Table table{"boxes",
              fmt::format("Runs in generation {}", report.generation),
              {"study", "values", "measure", "of", "season", "experiment",
               "runs", "median", "low quartile", "high quartile", "mean"},
              {}};
  for (const Finals& one : all)
    table.rows.push_back(
        {report.title, std::string(NameIn(kToldNames, one.told)),
         TitleWithUnit(report.measures[one.measure]), OfName(one.of),
         report.seasons[one.season], report.experiments[one.experiment].name,
         std::to_string(one.values.size()),
         NumberCell(one.box.quartiles.median),
         NumberCell(one.box.quartiles.low), NumberCell(one.box.quartiles.high),
         NumberCell(one.box.mean)});
  return table;
}

Table TestsTable(const StudyReport& report, const std::vector<Finals>& all) {
  Table table{"tests",
              "Wilcoxon rank-sum tests, not corrected for their number",
              {"study", "values", "measure", "season", "first", "second",
               "first runs", "second runs", "W", "p", "exact", "stars"},
              {}};
  for (const Test& test : TestsOf(report, all)) {
    const auto& result = test.result;
    table.rows.push_back(
        {report.title, std::string(NameIn(kToldNames, test.told)),
         report.measures[test.measure].title, report.seasons[test.season],
         report.experiments[test.first].name,
         report.experiments[test.second].name, std::to_string(test.first_runs),
         std::to_string(test.second_runs), result ? NumberCell(result->w) : "",
         result ? NumberCell(result->p) : "",
         result ? (result->is_exact ? "yes" : "no") : "",
         result ? std::string(Stars(result->p)) : ""});
  }
  return table;
}

Table SwapsTable(const StudyReport& report) {
  Table table{"swaps",
              "What plastic robots lose with another season's body and brain, "
              "cm/s",
              {"study", "values", "measure", "season", "experiment", "runs",
               "median", "low quartile", "high quartile", "V", "p", "stars"},
              {}};
  for (const SwapLosses& one : SwapLossesOf(report))
    table.rows.push_back(
        {report.title, "relived", one.measure, report.seasons[one.season],
         report.experiments[one.experiment].name,
         std::to_string(one.runs.size()), NumberCell(one.box.quartiles.median),
         NumberCell(one.box.quartiles.low), NumberCell(one.box.quartiles.high),
         one.result ? NumberCell(one.result->v) : "",
         one.result ? NumberCell(one.result->p) : "",
         one.result ? std::string(Stars(one.result->p)) : ""});
  return table;
}

/// A run in a season: its value of each measure, and then that of its best
/// robot; nothing if it has none.
std::optional<CellRow> RowOfRun(const StudyReport& report,
                                const std::vector<Finals>& all, std::size_t run,
                                std::size_t season, Told told) {
  CellRow cells(2 * report.measures.size());
  bool has_any = false;
  for (const Finals& one : all) {
    if (one.season != season || one.told != told) continue;
    for (const RunValue& value : one.values) {
      if (value.run != run) continue;
      const std::size_t place = one.of == Counted::kBest ? 1 : 0;
      cells[2 * one.measure + place] = NumberCell(value.value);
      has_any = true;
    }
  }
  if (!has_any) return std::nullopt;
  return cells;
}

Table RunsTable(const StudyReport& report, const std::vector<Finals>& all) {
  Table table{"runs",
              "Runs",
              {"study", "values", "run", "experiment", "season", "seed", "plsc",
               "results", "lives"},
              {}};
  for (const ReportMeasure& measure : report.measures)
    for (const char* of : {"", " of the best"})
      table.columns.push_back(TitleWithUnit(measure) + of);
  const auto add = [&](const ReportExperiment& experiment, std::size_t i,
                       std::size_t season, Told told) {
    const auto values = RowOfRun(report, all, i, season, told);
    if (!values) return;
    const ReportRun& run = report.runs[i];
    const RunFacts& facts = run.reading.facts;
    const int lives = told == Told::kRelived ? run.relived.generation.lives : 1;
    CellRow row{report.title,           std::string(NameIn(kToldNames, told)),
                run.input.label,        experiment.name,
                report.seasons[season], facts.seed,
                facts.versions.plsc,    std::to_string(facts.versions.results),
                std::to_string(lives)};
    row.insert(row.end(), values->begin(), values->end());
    table.rows.push_back(std::move(row));
  };
  for (const ReportExperiment& experiment : report.experiments)
    for (const std::size_t i : experiment.runs)
      for (const std::size_t season : experiment.seasons)
        for (const Told told : {Told::kRelived, Told::kRecorded})
          add(experiment, i, season, told);
  return table;
}

std::string MarkdownCell(const std::string& text) {
  std::string cell;
  for (const char c : text) {
    // A table's own sign, and those of emphasis, links and HTML.
    if (c == '|' || c == '*' || c == '_' || c == '<' || c == '[' || c == '`' ||
        c == '\\')
      cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

std::string MarkdownRow(const CellRow& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += ' ' + MarkdownCell(cell) + " |";
  return line + '\n';
}

/// Three digits, as papers have, of what is a number.
std::string Shown(const std::string& cell) {
  constexpr int kShown = 3;
  const auto number = ParseNumber<double>(cell);
  if (!number || cell.find('.') == std::string::npos) return cell;
  return PrintRoundedNumber(*number, kShown);
}

/// Without the study, and without columns that no row has anything in.
std::string TableMarkdown(const Table& table) {
  CellRow columns;
  std::vector<CellRow> rows(table.rows.size());
  for (std::size_t i = 1; i < table.columns.size(); ++i) {
    bool has_any = false;
    for (const CellRow& row : table.rows) has_any = has_any || !row[i].empty();
    if (!has_any || table.columns[i] == "hash") continue;
    columns.push_back(table.columns[i]);
    for (std::size_t k = 0; k < rows.size(); ++k)
      rows[k].push_back(Shown(table.rows[k][i]));
  }
  std::string text = MarkdownRow(columns);
  text += '|';
  for (std::size_t i = 0; i < columns.size(); ++i) text += "---|";
  text += '\n';
  for (const CellRow& row : rows) text += MarkdownRow(row);
  return text;
}

}  // namespace

std::vector<Table> TablesOf(const StudyReport& report,
                            const std::vector<ClaimResult>& claims) {
  const std::vector<Finals> all = AllFinals(report);
  return {ClaimsTable(report, claims), BoxesTable(report, all),
          TestsTable(report, all), SwapsTable(report), RunsTable(report, all)};
}

std::string TableCsv(const Table& table) {
  std::string text;
  const auto add = [&](const CellRow& row) {
    const char* separator = "";
    for (const std::string& cell : row) {
      text += separator + CsvCell(cell);
      separator = ",";
    }
    text += '\n';
  };
  add(table.columns);
  for (const CellRow& row : table.rows) add(row);
  return text;
}

std::string TablesMarkdown(const StudyReport& report,
                           const std::vector<Table>& tables) {
  std::string text =
      fmt::format("{}\n\n# {}\n", kTablesMark, MarkdownCell(report.title));
  for (const Table& table : tables) {
    if (table.name == "runs" || table.rows.empty()) continue;
    text += fmt::format("\n## {}\n\n{}", table.title, TableMarkdown(table));
  }
  return text;
}

}  // namespace plsc
