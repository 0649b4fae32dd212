#include "runtime/cli/running/simulation_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "runtime/cli/running/interrupt.h"
#include "runtime/cli/running/progress.h"

namespace plsc::cli {

namespace {

// s. Fast enough to look alive, slow enough to cost nothing; a robot that is
// done before the first gets no line.
constexpr double kShowAgain = 0.2;
// Steps between two looks at the clock: a look costs as much as 1/500 of a
// step, and 32 steps of a large robot are still less than a redraw.
constexpr std::int64_t kStepsPerLook = 32;

}  // namespace

std::string ProgressText(const SimulationProgress& progress) {
  std::string text = fmt::format(
      "season {} ({} of {})  {:.1f}/{:.1f} s", progress.season, progress.number,
      progress.seasons, progress.lived, progress.duration);
  const double lived = progress.lived_before + progress.lived;
  if (lived > 0 && progress.seconds > 0) {
    const double rate = lived / progress.seconds;
    text +=
        fmt::format("  {:.3g} x real time  {} left", rate,
                    DurationText(std::max(progress.all - lived, 0.0) / rate));
  }
  return text;
}

SimulationWatch::SimulationWatch(const Scenario& scenario,
                                 std::ostream* terminal, bool is_recording)
    : scenario_(scenario),
      terminal_(terminal),
      is_recording_(is_recording),
      start_(std::chrono::steady_clock::now()) {
  progress_.seasons = scenario.seasons.size();
  for (const Season& season : scenario.seasons)
    progress_.all += season.duration;
}

void SimulationWatch::Begin(const Phenotype& robot,
                            const SimulationOptions& options, double begin) {
  const Season& season = scenario_.seasons[progress_.number - 1];
  progress_.season = season.name;
  progress_.duration = season.duration;
  step_ = options.physics.step;
  if (is_recording_) recorder_.Begin(robot, options, begin);
}

bool SimulationWatch::See(const World& world, std::int64_t step) {
  if (is_recording_) recorder_.See(world, step);
  if (terminal_ != nullptr && step % kStepsPerLook == 0) Report(step);
  return !InterruptHandler::is_interrupted();
}

void SimulationWatch::Report(std::int64_t step) {
  const double now =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start_)
          .count();
  if (now - shown_at_ < kShowAgain) return;
  shown_at_ = progress_.seconds = now;
  progress_.lived = static_cast<double>(step) * step_;
  const std::string text = ProgressText(progress_);
  // Blanks wipe what is left of a longer line.
  *terminal_ << fmt::format("\r{:<{}}", text, width_) << std::flush;
  width_ = text.size();
}

Motion SimulationWatch::FinishSeason() {
  if (width_ > 0)
    *terminal_ << fmt::format("\r{:<{}}\r", "", width_) << std::flush;
  width_ = 0;
  progress_.lived_before += scenario_.seasons[progress_.number - 1].duration;
  progress_.lived = 0;
  ++progress_.number;
  return recorder_.Take();
}

}  // namespace plsc::cli
