#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "runtime/authors/genotype.h"
#include "runtime/evolve/breed.h"
#include "tests/runtime/cli/authors_mutation.h"
#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/cli/tiny_run.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

using Json = nlohmann::json;
using test::RunPlsc;

TEST_CASE("mutate makes the same change for the same seed", "[cli][mutate]") {
  const auto ran = RunPlsc({"mutate", "-", "--seed", "1"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(Compile(Source("mutant", ran.out)));
  CHECK(ran.err.starts_with("plastic: "));
  CHECK(RunPlsc({"mutate", "-", "--seed", "1"}, test::kPlasticText).out ==
        ran.out);
  std::size_t different = 0;
  for (const char* seed : {"2", "3", "4", "5", "6"})
    different +=
        RunPlsc({"mutate", "-", "--seed", seed}, test::kPlasticText).out !=
                ran.out
            ? 1
            : 0;
  CHECK(different >= 3);
}

TEST_CASE("mutate makes the mutation that a run of evolution makes",
          "[cli][mutate]") {
  Experiment experiment;
  experiment.seed = 7;
  experiment.mutation = 1;
  experiment.crossover = 0;
  std::vector<Individual> parents{CreateFirst(experiment, 1),
                                  CreateFirst(experiment, 2)};
  for (int id = 10; id < 40; ++id) {
    CAPTURE(id);
    const Individual child = CreateChild(experiment, 3, id, parents, {0, 0});
    const Genotype& parent =
        parents[static_cast<std::size_t>(child.heritage.parents[0] - 1)]
            .genotype;
    const auto ran =
        RunPlsc({"mutate", "-", "--seed", "7", "--generation", "3",
                 "--individual", std::to_string(id), "--format", "json"},
                Print(parent));
    REQUIRE(ran.exit == 0);
    const auto line = Json::parse(ran.out);
    Genotype wanted = child.genotype;
    wanted.name = parent.name;
    CHECK(line["text"] == Print(wanted));
    CHECK(line["mutation"] ==
          NameIn(kMutationNames, child.heritage.mutation->kind));
    CHECK(line["rule"] == child.heritage.mutation->rule + 1);
    CHECK(line["changed"] == (wanted != parent));
  }
}

TEST_CASE("mutate --count makes the children of ids that follow",
          "[cli][mutate]") {
  const test::TemporaryFolder folder;
  const std::string out = folder / "mutants.pls";
  CHECK(RunPlsc({"mutate", "-", "--seed", "1", "--count", "3", "-o", out},
                test::kPlasticText)
            .exit == 0);
  const auto all = CompileAll(Source("mutants", test::ReadFile(out)));
  REQUIRE(all);
  REQUIRE(all->size() == 3);
  CHECK((*all)[2].genotype.name == "plastic_3");
  CHECK((*all)[2].environments.size() == 2);
  const auto third = RunPlsc(
      {"mutate", "-", "--seed", "1", "--individual", "2"}, test::kPlasticText);
  Genotype wanted = Compile(Source("third", third.out))->genotype;
  wanted.name = "plastic_3";
  CHECK((*all)[2].genotype == wanted);
}

TEST_CASE("mutate takes an experiment's operators", "[cli][mutate]") {
  const test::TemporaryFolder folder;
  const std::string experiment =
      folder.Write("small.yaml", test::kTinyExperiment);
  const auto ran =
      RunPlsc({"mutate", "-", "--seed", "1", "--experiment", experiment},
              test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(RunPlsc({"mutate", "-", "--seed", "1", "--experiment",
                 folder.Write("bad.yaml", "population: x")},
                test::kPlasticText)
            .exit == 1);
}

TEST_CASE("mutate makes of an import what the authors' program could make",
          "[cli][mutate][import]") {
  const test::TemporaryFolder folder;
  const std::string program = folder.Write(
      "program.yaml", std::string(test::kTinyExperiment) +
                          "insertion: before_end\nremoval: by_value\n");
  const bool as_in_paper = GENERATE(true, false);
  const std::string count = std::to_string(test::Sampled(2000));
  for (const std::uint64_t seed : {1u, 2u}) {
    CAPTURE(seed, as_in_paper);
    Rng rng({seed, 0, 0, Purpose::kInitialise});
    const auto text = AuthorsGenotypeText(Initialise({}, rng));
    const auto imported = RunPlsc({"import", "-"}, *text);
    REQUIRE(imported.exit == 0);
    std::vector<std::string> command = {"mutate", "-",       "--seed",
                                        "1",      "--count", count};
    if (!as_in_paper) command.insert(command.end(), {"--experiment", program});
    const Genotype parent = Compile(Source("parent", imported.out))->genotype;
    const auto all =
        CompileAll(Source("mutants", RunPlsc(command, imported.out).out));
    REQUIRE(all);
    REQUIRE(std::to_string(all->size()) == count);
    std::size_t made = 0;
    for (const Program& child : *all)
      made +=
          test::AuthorsCanMake(parent, child.genotype, as_in_paper) ? 1U : 0U;
    CHECK(made == all->size());
  }
}

TEST_CASE("mutate refuses what its operators do not know", "[cli][mutate]") {
  const test::TemporaryFolder folder;
  const auto exit_of = [](const std::string& text) {
    return RunPlsc({"mutate", "-", "--seed", "1"}, text).exit;
  };
  CHECK(exit_of("plsc 1\nalphabet plasticoding 1\n") == 1);
  CHECK(exit_of("plsc 1\nalphabet a { replaceable X }\naxiom X\n"
                "rule X -> { X }\n") == 1);
  CHECK(exit_of("") == 1);
  CHECK(RunPlsc({"mutate", "-"}, test::kPlasticText).exit == 2);
  CHECK(RunPlsc({"mutate", "-", "--seed", "-1"}, test::kPlasticText).exit == 2);
  CHECK(RunPlsc({"mutate", "-", "--seed", "1", "--count", "0"},
                test::kPlasticText)
            .exit == 2);
  const std::string file = folder.Write("a.pls", test::kPlasticText);
  CHECK(RunPlsc({"mutate", file, "--seed", "1", "-o", file}).exit == 1);
  CHECK(test::ReadFile(file) == test::kPlasticText);
}

}  // namespace
}  // namespace plsc
