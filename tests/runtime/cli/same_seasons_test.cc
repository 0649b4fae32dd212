// Runs whose seasons are partly the same to the physics, from the command line
// to the store and back: with a cache that all of them share, and replayed.

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "runtime/evolve/experiment.h"
#include "runtime/store/result_dump.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/evolve/same_seasons.h"
#include "tests/sanitizer.h"

namespace plsc {

using test::RunPlsc;

TEST_CASE("runs with equal seasons are made, looked up and replayed alike",
          "[evolve][replay]") {
  const test::TemporaryFolder folder;
  const auto evolve = [&](const std::string& name,
                          const std::vector<std::string>& options) {
    std::vector<std::string> words = {"evolve",  "-o",     folder / name,
                                      "--quiet", "--jobs", "1"};
    words.insert(words.end(), options.begin(), options.end());
    const auto ran = RunPlsc(words);
    INFO(ran.err);
    CHECK(ran.exit == 0);
    const auto dump = DumpResults(folder / name);
    CHECK(dump);
    return *dump;
  };
  Experiment experiment;
  experiment.population = 4;
  experiment.offspring = 4;
  experiment.generations = 2;
  experiment.genotype.states = {{"inclined", StateType::kBool, 0, 0, {}},
                                {"hot", StateType::kBool, 0, 0, {}}};
  std::size_t turn = 0, skipped = 0;
  for (const std::vector<int>& pattern : test::SeasonPatterns(4)) {
    // generation_seasons_test.cc has all of them.
    if (pattern.size() == 4 && ++skipped % 3 != 0) continue;
    const auto variants = test::PatternVariants(pattern);
    experiment.scenario = variants[turn % variants.size()];
    experiment.genotype.encoding = turn / variants.size() % 2 == 0
                                       ? Encoding::kPlasticoding
                                       : Encoding::kBaseline;
    if (!test::IsSampled(turn++)) continue;
    INFO(PrintExperiment(experiment));
    folder.Write("e.yaml", PrintExperiment(experiment));
    const std::string name = "run" + std::to_string(turn);
    const std::string yaml = folder / "e.yaml";
    const std::string plain = evolve(name, {yaml});
    CHECK(evolve(name + "b", {yaml, "--cache", folder / "c"}) == plain);
    CHECK(evolve(name + "c", {yaml, "--cache", folder / "c"}) == plain);
    CHECK(evolve(name + "d", {"--salvage", folder / name}) == plain);
    const auto replayed = RunPlsc({"replay", folder / name, "--all"});
    INFO(replayed.out + replayed.err);
    CHECK(replayed.exit == 0);
  }
}

}  // namespace plsc
