#include "runtime/cli/robots/recorded_life.h"

#include <fmt/format.h>

#include <ostream>
#include <utility>

#include "compiler/print.h"
#include "grammar/shown_line.h"
#include "runtime/scenario/scenario_yaml.h"

namespace plsc::cli {

RecordedLife::RecordedLife(const Genotype& genotype, const Scenario& scenario,
                           const Circumstances& circumstances,
                           bool is_recording, Io& io)
    : scenario_(scenario),
      is_recording_(is_recording),
      watch_(scenario_, io.err_is_terminal ? &io.err : nullptr, is_recording),
      life_(genotype, scenario_, &watch_, circumstances.inherited,
            circumstances.disturbances),
      recording_{genotype.name, Print(genotype), PrintScenario(scenario_), {}} {
}

SeasonLife RecordedLife::Next() {
  SeasonLife life = life_.Next();
  Motion motion = watch_.FinishSeason();
  if (is_recording_)
    recording_.seasons.push_back(RecordSeason(
        scenario_, scenario_.seasons[lived_], life, std::move(motion)));
  ++lived_;
  return life;
}

}  // namespace plsc::cli
