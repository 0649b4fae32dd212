#include "runtime/advice/trim.h"
#include "grammar/shown_line.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>

#include "runtime/cli/arguments/genotypes.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/cli/files/output_path.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/life/season_environments.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

Json CountsJson(const PieceCounts& counts) {
  return {{"rules", counts.rules},
          {"terms", counts.terms},
          {"symbols", counts.symbols}};
}

Json RegimeJson(const ComparedRegime& regime) {
  return {{"where", regime.where},
          {"environments", regime.count},
          {"named", regime.named},
          {"before", Hex(regime.before)},
          {"after", Hex(regime.after)}};
}

Json TrimJson(const Source& source, const Trimmed& trimmed) {
  Json genotypes = Json::array();
  for (const TrimmedGenotype& one : trimmed.genotypes) {
    Json proof = Json::array();
    for (const ComparedRegime& regime : one.proof)
      proof.push_back(RegimeJson(regime));
    genotypes.push_back({{"genotype", one.name},
                         {"before", CountsJson(one.before)},
                         {"after", CountsJson(one.after)},
                         {"proof", std::move(proof)}});
  }
  return {{"file", source.name()},
          {"complete", trimmed.is_complete},
          {"genotypes", std::move(genotypes)},
          {"text", trimmed.text}};
}

std::string Of(std::size_t after, std::size_t before, const char* what) {
  return fmt::format("{} of {} {}", before - after, before, what);
}

std::string NamesOf(const ComparedRegime& regime) {
  std::string text = regime.where;
  if (regime.count > 1)
    text += fmt::format(" and {} more alike", regime.count - 1);
  if (!regime.named.empty())
    text += fmt::format(" ({})", fmt::join(regime.named, ", "));
  return text;
}

void ReportProof(const Source& source, const Trimmed& trimmed, Io& io) {
  for (const TrimmedGenotype& one : trimmed.genotypes) {
    io.err << fmt::format(
        "{}: {}: {}, {} and {} left out\n", Escaped(source.name()), one.name,
        Of(one.after.symbols, one.before.symbols, "symbols"),
        Of(one.after.rules, one.before.rules, "rules"),
        Of(one.after.terms, one.before.terms, "terms of clauses"));
    for (const ComparedRegime& regime : one.proof)
      io.err << fmt::format("  {}: before {}, after {}\n", NamesOf(regime),
                            Hex(regime.before), Hex(regime.after));
  }
  if (!trimmed.is_complete)
    io.err << "note: there was too much to try; trimming again may find more\n";
}

// `name` of FILE#NAME among the genotypes of the file.
std::optional<std::size_t> Only(const LoadedFile& file) {
  if (file.chosen.size() == file.all.size()) return std::nullopt;
  return file.chosen.front();
}

// Where each genotype of the file may develop in the scenario. Prints what is
// wrong.
bool PutIntoSeasons(const std::string& scenario_file, const LoadedFile& file,
                    TrimOptions& options, Io& io) {
  if (scenario_file.empty()) return true;
  const auto scenario = LoadScenario(scenario_file, io);
  if (!scenario) return false;
  for (const MappedProgram& one : file.all) {
    const Genotype& genotype = one.program.genotype;
    if (!CanLive(*scenario, genotype, io)) return false;
    options.lived.push_back(PossibleEnvironments(genotype, *scenario));
  }
  return true;
}

Output OutputOf(const TrimCommand& command) {
  return {command.output,
          OutputKind::kGenotype,
          command.force,
          {SplitGenotypePath(command.file).file, command.scenario}};
}

// Whether the text went where it was wanted.
bool Deliver(const TrimCommand& command, const Source& source,
             const Trimmed& trimmed, Io& io) {
  if (command.check) return true;
  if (!command.write) {
    // The text is in the JSON, too.
    const bool is_told =
        command.output.empty() && command.format == OutputFormat::kJson;
    return is_told || WriteOutput(OutputOf(command), trimmed.text, io);
  }
  return trimmed.text == source.text() ||
         WriteOrReport(source.name(), trimmed.text, io);
}

}  // namespace

Exit Run(const TrimCommand& command, Io& io) {
  const std::string input = SplitGenotypePath(command.file).file;
  if (command.write && input == "-") {
    io.err << "plsc: --write wants a file, not standard input\n";
    return Exit::kBadUsage;
  }
  if (!CanWrite(OutputOf(command), io)) return Exit::kBadInput;
  const auto file = LoadFile(command.file, command.allow_range, io);
  if (!file) return Exit::kBadInput;
  TrimOptions options;
  options.only = Only(*file);
  options.compile.allow_out_of_range = command.allow_range;
  if (!PutIntoSeasons(command.scenario, *file, options, io))
    return Exit::kBadInput;
  const Result<Trimmed> trimmed = Trim(file->source, options);
  if (!trimmed) {
    Report(trimmed.diagnostics(), file->source, io);
    return Exit::kBadInput;
  }
  if (!Deliver(command, file->source, *trimmed, io)) return Exit::kBadInput;
  if (command.format == OutputFormat::kJson)
    io.out << DumpJson(TrimJson(file->source, *trimmed)) << '\n';
  else
    ReportProof(file->source, *trimmed, io);
  const bool would_change = trimmed->text != file->source.text();
  return command.check && would_change ? Exit::kBadInput : Exit::kFine;
}

}  // namespace plsc::cli
