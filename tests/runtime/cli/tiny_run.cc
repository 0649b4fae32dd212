#include "tests/runtime/cli/tiny_run.h"

#include <cassert>

namespace plsc::test {

const char* const kTinyExperiment = R"(plsc_experiment: 1
name: tiny
population: 6
offspring: 6
generations: 3
scenario:
  seasons:
    - {name: flat, terrain: flat, duration: 1 s}
    - {name: hill, terrain: {tilted: 5 deg}, duration: 1 s}
)";

TinyRun::TinyRun() {
  const auto ran = RunPlsc({"evolve", folder_.Write("e.yaml", kTinyExperiment),
                            "-o", path(), "--quiet", "--format", "json"});
  assert(ran.exit == 0);
  summary_ = nlohmann::json::parse(ran.out);
}

const TinyRun& FinishedRun() {
  static const TinyRun run;
  return run;
}

}  // namespace plsc::test
