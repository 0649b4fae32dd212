#include "runtime/evolve/run_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "compiler/print.h"
#include "runtime/formats/season_json.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;
using Failure = std::optional<std::string>;

constexpr int kFormat = 1;  // of the folder, run.json's plsc_run

std::string Explain(const char* what, const std::string& path, int error) {
  return fmt::format("cannot {} '{}': {}", what, path,
                     std::error_code(error, std::generic_category()).message());
}

std::string RunJson(const Experiment& experiment) {
  Json json;
  json["plsc_run"] = kFormat;
  json["name"] = experiment.name;
  json["seed"] = experiment.seed;
  json["evaluations"] = Evaluations(experiment);
  json["seasons"] = Json::array();
  for (const Season& season : experiment.scenario.seasons)
    json["seasons"].push_back(season.name);
  json["versions"] = {{"plsc", PLSC_VERSION},
                      {"ode", PLSC_ODE_VERSION},
                      {"compiler", __VERSION__}};
  // With every constant of the physics, as text that reads back equal.
  json["experiment"] = PrintExperiment(experiment);
  json["scenario"] = PrintScenario(experiment.scenario);
  return json.dump(2) + "\n";
}

Json HeritageJson(const Individual& one) {
  const Heritage& heritage = one.heritage;
  Json json;
  json["parents"] = heritage.parents;
  json["from_second"] = Json::array();
  for (const SymbolId head : heritage.from_second)
    json["from_second"].push_back((*one.genotype.alphabet)[head].name);
  if (heritage.mutation) {
    json["mutation"] = MutationName(heritage.mutation->kind);
    json["mutated_rule"] = heritage.mutation->rule;
  } else {
    json["mutation"] = nullptr;
    json["mutated_rule"] = nullptr;
  }
  return json;
}

std::string IndividualJson(const Individual& one) {
  Json json;
  json["id"] = one.id;
  json["generation"] = one.generation;
  json.update(HeritageJson(one));
  json["genotype"] = Print(one.genotype);
  std::string text = json.dump();
  text.pop_back();  // the closing brace: the seasons are still to come
  std::string seasons;
  for (const SeasonResult& season : one.evaluation.seasons) {
    if (!seasons.empty()) seasons += ',';
    seasons += SeasonJson(one.genotype.name, season);
  }
  return fmt::format("{},\"seasons\":[{}]}}\n", text, seasons);
}

std::string GenerationJson(const GenerationRecord& record) {
  Json json;
  json["generation"] = record.generation;
  json["best"] = record.best;
  json["pool"] = record.pool;
  json["counts"] = record.counts;
  json["survivors"] = record.survivors;
  return json.dump() + "\n";
}

/// A whole file at once.
Failure WriteNew(const std::string& path, const std::string& text) {
  LogFile file;
  if (Failure failure = file.Create(path)) return failure;
  if (Failure failure = file.Write(text)) return failure;
  return file.Close();
}

}  // namespace

LogFile::~LogFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

Failure LogFile::Create(const std::string& path) {
  path_ = path;
  descriptor_ =
      open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor_ < 0) return Explain("create", path_, errno);
  return std::nullopt;
}

Failure LogFile::Write(const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t count =
        write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Explain("write to", path_, errno);
    written += static_cast<std::size_t>(count);
  }
  return std::nullopt;
}

Failure LogFile::Close() {
  // Network file systems tell only here that a write failed.
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor >= 0 && close(descriptor) != 0)
    return Explain("finish", path_, errno);
  return std::nullopt;
}

Failure RunLog::Create(const std::string& folder,
                       const Experiment& experiment) {
  std::error_code error;
  if (!std::filesystem::create_directory(folder, error)) {
    if (error) return Explain("create", folder, error.value());
    return fmt::format("'{}' exists; a run is never overwritten", folder);
  }
  folder_ = folder;
  if (Failure failure = WriteNew(folder + "/run.json", RunJson(experiment)))
    return failure;
  if (Failure failure = individuals_.Create(folder + "/individuals.jsonl"))
    return failure;
  return generations_.Create(folder + "/generations.jsonl");
}

Failure RunLog::OnBirths(const std::vector<Individual>&) {
  return std::nullopt;
}

Failure RunLog::OnEvaluated(const Individual& one,
                            const std::vector<SeasonEvidence>&) {
  return individuals_.Write(IndividualJson(one));
}

Failure RunLog::OnGeneration(const GenerationRecord& record) {
  return generations_.Write(GenerationJson(record));
}

Failure RunLog::Finish(const RunResult& result) {
  Failure failure;
  if (result.best)
    failure = WriteNew(folder_ + "/best.pls", Print(result.best->genotype));
  // All are closed, whatever the first failure was.
  for (LogFile* file : {&individuals_, &generations_})
    if (Failure other = file->Close(); other && !failure) failure = other;
  return failure;
}

}  // namespace plsc
