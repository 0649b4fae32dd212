#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "grammar/number.h"
#include "runtime/cli/live/run_feed.h"
#include "runtime/cli/live/subject.h"
#include "runtime/server/query.h"
#include "runtime/study/run_report.h"
#include "runtime/study/study_folder.h"
#include "runtime/text/json_dump.h"

namespace plsc::cli {

namespace {

using Value = nlohmann::ordered_json;

server::Response Of(const Failure& failure) {
  return {500, "application/json",
          DumpJson(Value{{"ok", false}, {"error", failure.text}}), false};
}

/// One run, or the runs of a study by their names; the feed that a page asks
/// for is followed from then on.
class RunSubject : public Subject {
 public:
  explicit RunSubject(const std::string& path)
      : title_(std::filesystem::path(path).filename().string()) {
    feeds_.emplace("", RunFeed(path));
  }
  RunSubject(std::string folder, Study study)
      : title_(study.name.empty() ? folder : study.name),
        folder_(std::move(folder)),
        study_(std::move(study)) {}

  MaybeFailure Check() {
    for (auto& [name, feed] : feeds_)
      if (const auto seen = feed.Look(); !seen) return seen.error();
    return std::nullopt;
  }

  std::string Title() const override { return title_; }

  std::string PageData() const override {
    Value json;
    json["robot"] = "";
    json["name"] = title_;
    json["scenario"] = study_ ? "" : feeds_.at("").scenario();
    json["server"] = Value::object();
    json["follow"] = study_ ? "study" : "run";
    return DumpJson(json);
  }

  std::vector<Event> Standing() const override {
    std::vector<Event> events;
    for (const auto& [name, feed] : feeds_) events.push_back(Told(name, feed));
    return events;
  }

  std::vector<Event> Look() override {
    std::vector<Event> events;
    for (auto& [name, feed] : feeds_) {
      const auto seen = feed.Look();
      if (seen && *seen) events.push_back(Told(name, feed));
    }
    return events;
  }

  server::Response Answer(const server::Request& request) override {
    const bool is_study = request.target == "study" && study_;
    if (request.target != "run" && request.target != "robot" && !is_study)
      return server::Refusal(404, "there is no such thing here");
    if (request.method != "GET") return server::Refusal(405, "this is to GET");
    if (is_study) return {200, "application/json", StudyJson(), false};
    const auto feed =
        Find(server::QueryValue(request.query, "run").value_or(""));
    if (!feed) return Of(feed.error());
    if (request.target == "run")
      return {200, "application/json", (*feed)->Json(), false};
    const auto id =
        ParseNumber<int>(server::QueryValue(request.query, "id").value_or(""));
    if (!id) return server::Refusal(400, "?id= must be a robot's number");
    const auto robot = (*feed)->Robot(*id);
    if (!robot) return Of(robot.error());
    return {200, "application/json", *robot, false};
  }

 private:
  /// Events of several runs have names of their own, so that none takes the
  /// place of another's.
  static Event Told(const std::string& name, const RunFeed& feed) {
    return {name.empty() ? "run" : "run:" + name, feed.Summary()};
  }

  Expected<RunFeed*, Failure> Find(const std::string& name) {
    const auto known = feeds_.find(name);
    if (known != feeds_.end()) return &known->second;
    if (study_)
      for (const StudyRun& run : RunsOf(*study_)) {
        if (RunName(*study_, run) != name) continue;
        RunFeed feed(RunPath(folder_, *study_, run));
        if (const auto seen = feed.Look(); !seen) return seen.error();
        return &feeds_.emplace(name, std::move(feed)).first->second;
      }
    return Failure("there is no run '" + name + "'");
  }

  std::string StudyJson() const {
    Value json;
    json["name"] = title_;
    json["runs"] = Value::array();
    for (const StudyRun& run : RunsOf(*study_)) {
      const RunReport report = ReportOn(folder_, *study_, run);
      Value one;
      one["run"] = RunName(*study_, run);
      one["experiment"] = study_->experiments[run.experiment].name;
      one["state"] = NameIn(kRunStateNames, report.state);
      one["generations"] = report.generations;
      one["best"] = Value::array();
      for (const SeasonSpeed& season : report.best)
        one["best"].push_back(
            {{"season", season.season},
             {"speed", season.speed ? Value(*season.speed) : Value(nullptr)}});
      json["runs"].push_back(std::move(one));
    }
    return DumpJson(json);
  }

  std::string title_;
  std::string folder_;
  std::optional<Study> study_;
  std::map<std::string, RunFeed> feeds_;
};

}  // namespace

Expected<std::unique_ptr<Subject>, Failure> JoinRun(const std::string& path) {
  auto subject = std::make_unique<RunSubject>(path);
  if (auto failure = subject->Check()) return *failure;
  return std::unique_ptr<Subject>(std::move(subject));
}

Expected<std::unique_ptr<Subject>, Failure> JoinStudy(
    const std::string& folder) {
  Expected<Study, Failure> study = StudyIn(folder);
  if (!study) return study.error();
  return std::unique_ptr<Subject>(
      std::make_unique<RunSubject>(folder, std::move(*study)));
}

}  // namespace plsc::cli
