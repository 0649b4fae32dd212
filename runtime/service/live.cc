#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compiler/print.h"
#include "runtime/life/life.h"
#include "runtime/life/season_environments.h"
#include "runtime/life/season_json.h"
#include "runtime/recording/view_json.h"
#include "runtime/scenario/scenario_yaml.h"
#include "runtime/service/asks.h"
#include "runtime/service/limits.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"
#include "sim/pose_recorder.h"
#include "sim/watcher.h"

namespace plsc::service {

namespace {

/// Records if asked to, and ends a life before a season that would take more
/// work than may be.
class Watch : public Watcher {
 public:
  explicit Watch(bool is_recording) : is_recording_(is_recording) {}

  void Begin(const Phenotype& robot, const SimulationOptions& options,
             double begin) override {
    const auto joints = std::count_if(
        robot.body.modules.begin(), robot.body.modules.end(),
        [](const Module& module) { return IsJoint(module.type); });
    work_ += options.duration / options.physics.step *
             static_cast<double>(joints + 1);
    if (is_recording_) recorder_.Begin(robot, options, begin);
  }
  bool See(const World& world, std::int64_t step) override {
    if (is_recording_) recorder_.See(world, step);
    return !is_too_much();
  }

  /// Steps times links of the seasons so far.
  double work() const { return work_; }
  bool is_too_much() const { return work_ > kMostLinkSteps; }
  Motion Take() { return recorder_.Take(); }

 private:
  bool is_recording_;
  PoseRecorder recorder_;
  double work_ = 0;
};

void RefuseUnanswered(const Scenario& scenario, const Subject& subject) {
  RefuseBodiless(subject.genotype(), "simulate");
  RefuseMissingEngine(scenario);
  const std::vector<Diagnostic> problems =
      CheckSenses(scenario, subject.genotype().states);
  if (!problems.empty()) throw Refusal(problems, Source(kScenarioName, ""));
  RefuseGrowth(subject, PossibleEnvironments(subject.genotype(), scenario));
}

}  // namespace

Answer LiveAll(const Request& request) {
  const Subject subject = SubjectOf(request);
  const Scenario scenario = ScenarioOf(request);
  const bool is_recording = request.Flag("record");
  RefuseUnanswered(scenario, subject);
  const Genotype& genotype = subject.genotype();
  Watch watch(is_recording);
  Life life(genotype, scenario, &watch);
  Recording recording{
      genotype.name, Print(genotype), PrintScenario(scenario), {}};
  Evaluation evaluation;
  for (const Season& season : scenario.seasons) {
    const SeasonLife lived = life.Next();
    if (watch.is_too_much())
      throw Refusal(fmt::format(
          "to live until the end of season '{}' takes {:.3g} steps times "
          "links, more than {:.3g}: a shorter life, a longer step or fewer "
          "joints",
          season.name, watch.work(), kMostLinkSteps));
    if (is_recording)
      recording.seasons.push_back(
          RecordSeason(scenario, season, lived, watch.Take()));
    evaluation.seasons.push_back(lived.result);
  }
  Answer answer;
  answer.Add("genotype", genotype.name);
  answer.AddMembers(EvaluationJson(genotype, evaluation));
  if (is_recording)
    answer.AddWritten("view",
                      ViewJson({{subject.source.name(), "", recording}}));
  return answer;
}

}  // namespace plsc::service
