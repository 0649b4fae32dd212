#include "runtime/cli/commands/view_lives.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string_view>
#include <utility>
#include <variant>

#include "grammar/shown_line.h"
#include "runtime/cli/files/load_program.h"
#include "runtime/cli/files/load_yaml.h"
#include "runtime/cli/files/open_run.h"
#include "runtime/cli/robots/recorded_life.h"
#include "runtime/cli/robots/robot_source.h"
#include "runtime/cli/running/interrupt.h"
#include "runtime/recording/recording_json.h"
#include "runtime/recording/view_json.h"

namespace plsc::cli {

namespace {

/// Who is to be lived, with all that is known of the life already.
struct LifeToView {
  std::string source;
  Genotype genotype;
  Scenario scenario;
  Senses inherited;
  Disturbances disturbances;
  std::string run;  ///< whose life it is again; empty: of none
  Versions versions;
  std::vector<SeasonResult> stored;
};
using Viewed = std::variant<ViewedLife, LifeToView>;

// What a page has to be called by, whatever folder it was made in.
std::string FileName(const std::string& path) {
  return path == "-" ? "standard input"
                     : std::filesystem::path(path).filename().string();
}

std::string Beginning(const std::string& path) {
  std::error_code error;
  // A pipe can be read once.
  if (!std::filesystem::is_regular_file(path, error)) return "";
  std::ifstream file(path, std::ios::binary);
  std::array<char, 64> bytes{};
  file.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

ViewInputKind KindOf(const std::string& path) {
  if (IsDatabase(path)) return ViewInputKind::kRun;
  const std::string beginning = Beginning(path);
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && beginning[first] == '{')
    return ViewInputKind::kRecording;
  if (path.ends_with(".sqlite")) return ViewInputKind::kRun;
  if (path.ends_with(".json")) return ViewInputKind::kRecording;
  return ViewInputKind::kGenotype;
}

bool IsRobot(const std::string& word) {
  return word == "best" ||
         (!word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
           return c >= '0' && c <= '9';
         }));
}

std::optional<Viewed> LoadRecording(const std::string& path, Io& io) {
  const auto source = ReadOrReport(path, io);
  if (!source) return std::nullopt;
  Result<Recording> recording = ParseRecording(*source);
  Report(recording.diagnostics(), *source, io);
  if (!recording) return std::nullopt;
  return ViewedLife{FileName(path), "", std::move(*recording)};
}

std::optional<Viewed> LoadGenotype(const std::string& path,
                                   const Scenario& scenario, Io& io) {
  const auto program = LoadProgram(path, false, io);
  if (!program || !CanLive(scenario, program->genotype, io))
    return std::nullopt;
  return LifeToView{
      FileName(path), program->genotype, scenario, {}, {}, "", {}, {}};
}

/// `engine`: as ViewCommand's.
bool LoadRobots(const ViewInput& input, std::optional<EngineKind> engine,
                std::vector<Viewed>& viewed, Io& io) {
  RunStore store;
  if (const auto failure = store.OpenForReading(input.path)) {
    Complain(*failure, io);
    return false;
  }
  const Expected<std::vector<int>, Failure> ids = IdsOf(store, input.robots);
  if (!ids) {
    Complain(ids.error(), io);
    return false;
  }
  Scenario scenario = store.experiment().scenario;
  const Scenario as_stored = scenario;
  if (!UseEngine(engine, scenario, io)) return false;
  // A life of another engine is not the one of the run.
  const bool is_replay = scenario == as_stored;
  for (const int id : *ids) {
    Expected<Individual, Failure> one = store.FindFirstLife(id);
    if (!one) {
      Complain(one.error(), io);
      return false;
    }
    const std::string source =
        fmt::format("{}, robot {}", FileName(input.path), id);
    // Nobody who was bred for another scenario is in a store.
    viewed.emplace_back(
        LifeToView{source, std::move(one->genotype), scenario,
                   std::move(one->heritage.senses),
                   std::move(one->disturbances), is_replay ? input.path : "",
                   store.versions(), std::move(one->evaluation.seasons)});
  }
  return true;
}

bool LoadInput(const ViewInput& input, const Scenario& scenario,
               std::optional<EngineKind> engine, std::vector<Viewed>& viewed,
               Io& io) {
  if (input.kind == ViewInputKind::kRun)
    return LoadRobots(input, engine, viewed, io);
  auto one = input.kind == ViewInputKind::kRecording
                 ? LoadRecording(input.path, io)
                 : LoadGenotype(input.path, scenario, io);
  if (one) viewed.push_back(std::move(*one));
  return one.has_value();
}

/// Season by season: the state at its end is a function of every bit before.
bool IsSame(const std::vector<SeasonResult>& stored,
            const std::vector<SeasonResult>& now) {
  return std::equal(stored.begin(), stored.end(), now.begin(), now.end(),
                    [](const SeasonResult& a, const SeasonResult& b) {
                      return a.outcome == b.outcome &&
                             a.state_hash == b.state_hash;
                    });
}

std::string RemarkOn(const LifeToView& one,
                     const std::vector<SeasonResult>& now) {
  if (one.run.empty()) return "";
  if (one.stored.empty()) return "not evaluated yet in the run";
  if (IsSame(one.stored, now)) return "";
  return fmt::format(
      "this life is not, to the last bit, the one of the run, which {} began",
      VersionsText(one.versions));
}

std::optional<ViewedLife> LiveNow(const LifeToView& one, Io& io) {
  RecordedLife life(one.genotype, one.scenario,
                    {one.inherited, one.disturbances}, true, io);
  std::vector<SeasonResult> results;
  while (!life.is_over()) {
    results.push_back(life.Next().result);
    if (InterruptHandler::is_interrupted()) return std::nullopt;
  }
  std::string remark = RemarkOn(one, results);
  if (!remark.empty())
    io.err << fmt::format("warning: {}: {}\n", Escaped(one.source), remark);
  return ViewedLife{one.source, std::move(remark), life.recording()};
}

}  // namespace

std::vector<ViewInput> SortInputs(const std::vector<std::string>& inputs) {
  std::vector<ViewInput> sorted;
  for (const std::string& input : inputs) {
    const bool follows_run =
        !sorted.empty() && sorted.back().kind == ViewInputKind::kRun;
    if (follows_run && IsRobot(input))
      sorted.back().robots.push_back(input);
    else
      sorted.push_back({KindOf(input), input, {}});
  }
  return sorted;
}

std::optional<std::vector<ViewedLife>> LoadLives(const ViewCommand& command,
                                                 Io& io) {
  auto scenario = LoadScenario(command.scenario, io);
  if (!scenario || !UseEngine(command.engine, *scenario, io))
    return std::nullopt;
  std::vector<Viewed> viewed;
  bool is_fine = true;
  for (const ViewInput& input : SortInputs(command.inputs))
    is_fine &= LoadInput(input, *scenario, command.engine, viewed, io);
  if (!is_fine) return std::nullopt;
  std::vector<ViewedLife> lives;
  for (Viewed& one : viewed) {
    if (auto* life = std::get_if<ViewedLife>(&one)) {
      lives.push_back(std::move(*life));
      continue;
    }
    auto life = LiveNow(std::get<LifeToView>(one), io);
    if (!life) return std::nullopt;
    lives.push_back(std::move(*life));
  }
  return lives;
}

}  // namespace plsc::cli
