#include "runtime/cli/running/json_log.h"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "runtime/cli/files/io.h"
#include "runtime/cli/files/output_file.h"
#include "runtime/cli/files/pipe_errors.h"
#include "runtime/cli/running/progress.h"
#include "runtime/cli/running/utc_now.h"
#include "runtime/text/json_dump.h"
#include "runtime/text/system_reason.h"

namespace plsc::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kPause = 10;  // s

Json OrNull(const std::optional<double>& number) {
  return number ? Json(*number) : Json(nullptr);
}

/// What every line begins with.
Json Begin(const char* event, double seconds) {
  Json json;
  json["event"] = event;
  json["time"] = UtcNow();
  json["seconds"] = seconds;
  return json;
}

void AddProgress(const Progress& progress, const Pace& pace, Json& json) {
  json["generation"] = progress.generation;
  json["evaluations"] = progress.evaluations;
  json["total"] = progress.total;
  json["workers"] = progress.workers;
  json["busy_workers"] = progress.busy_workers;
  json["simulations"] = progress.simulations;
  json["looked_up"] = progress.looked_up;
  json["looked_up_share"] = OrNull(pace.looked_up_share);
  json["simulated_seconds"] = progress.simulated_seconds;
  json["evaluations_per_second"] = OrNull(pace.evaluations_per_second);
  json["times_real"] = OrNull(pace.times_real);
  json["seconds_left"] = OrNull(pace.seconds_left);
  json["seasons"] = Json::array();
  for (const SeasonProgress& season : progress.seasons)
    json["seasons"].push_back({{"season", season.season},
                               {"best", OrNull(season.best)},
                               {"median", OrNull(season.median)}});
}

// Lines are added to what is a log or nothing yet, never to another file.
std::optional<std::string> ProblemOfLog(const std::string& path) {
  std::error_code error;
  if (IsDescriptor(path)) return std::nullopt;
  if (!std::filesystem::exists(path, error)) {
    if (std::filesystem::is_symlink(path, error))
      return "it is a symbolic link that leads nowhere";
    return std::nullopt;
  }
  if (!std::filesystem::is_regular_file(path, error) ||
      std::filesystem::file_size(path, error) == 0)
    return std::nullopt;
  constexpr std::string_view kBegin = R"({"event":"start",)";
  std::string begin(kBegin.size(), '\0');
  std::ifstream file(path, std::ios::binary);
  if (file.read(begin.data(), static_cast<std::streamsize>(begin.size())) &&
      begin == kBegin)
    return std::nullopt;
  return "it is no log that `plsc evolve --json-log` began; choose another "
         "name";
}

}  // namespace

JsonLog::JsonLog(std::ostream& standard_output)
    : standard_output_(standard_output), clock_(Stopwatch()) {}

MaybeFailure JsonLog::Open(const std::string& path) {
  path_ = path;
  if (path == "-") {
    path_ = "standard output";
    out_ = &standard_output_;
    return std::nullopt;
  }
  if (const auto problem = ProblemOfLog(path))
    return fmt::format("cannot write to '{}': {}", path, *problem);
  std::error_code error;
  is_new_ = !std::filesystem::exists(path, error);
  errno = 0;
  file_.open(path, std::ios::app);
  if (!file_)
    return fmt::format("cannot write to '{}': {}", path, SystemReason(errno));
  out_ = &file_;
  return std::nullopt;
}

void JsonLog::Discard() {
  out_ = nullptr;
  if (!file_.is_open()) return;
  file_.close();
  std::error_code ignored;
  if (is_new_) std::filesystem::remove(path_, ignored);
}

void JsonLog::Start(const JsonLogStart& start) {
  meter_ = PaceMeter(start.evaluations);
  last_.evaluations = start.evaluations;
  last_.total = start.total;
  Json json = Begin("start", clock_());
  json["log"] = 2;  // of this format; in 1 the seed was a number
  json["run"] = start.run;
  json["experiment"] = start.experiment;
  json["seed"] = std::to_string(start.seed);
  json["generations"] = start.generations;
  json["evaluations"] = start.evaluations;
  json["total"] = start.total;
  Write(DumpJson(json));
}

void JsonLog::Report(const Progress& progress) {
  const double now = clock_();
  const bool is_new = !has_progress_ || progress.generation != last_.generation;
  meter_.Add(now, progress);
  last_ = progress;
  has_progress_ = true;
  if (is_new)
    WriteProgress("generation", now);
  else
    Tick();
}

void JsonLog::Tick() {
  const double now = clock_();
  if (now - written_at_ >= kPause) WriteProgress("progress", now);
}

void JsonLog::WriteProgress(const char* event, double now) {
  Json json = Begin(event, now);
  AddProgress(last_, meter_.At(now), json);
  Write(DumpJson(json));
  written_at_ = now;
}

void JsonLog::Finish(Ending ending, const std::string& failure) {
  const double now = clock_();
  Json json = Begin("end", now);
  json["ending"] = NameIn(kEndingNames, ending);
  json["failure"] = ending == Ending::kFailed ? Json(failure) : Json(nullptr);
  AddProgress(last_, meter_.At(now), json);
  Write(DumpJson(json));
}

void JsonLog::Write(const std::string& line) {
  if (out_ == nullptr || failure_) return;
  // A run outlives the reader of its log.
  const PipeErrors are_errors;
  errno = 0;
  *out_ << line << std::endl;
  if (*out_) return;
  failure_ =
      fmt::format("cannot write to '{}': {}", path_, SystemReason(errno));
  if (out_ == &file_) file_.close();  // which tries once more
}

}  // namespace plsc::cli
