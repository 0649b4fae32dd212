#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "compiler/compile.h"
#include "compiler/print.h"
#include "runtime/evolve/breed.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("cross makes the crossover that a run of evolution makes",
          "[cli][cross]") {
  const test::TemporaryFolder folder;
  Experiment experiment;
  experiment.seed = 7;
  experiment.mutation = 0;
  experiment.crossover = 1;
  std::vector<Individual> parents{CreateFirst(experiment, 1),
                                  CreateFirst(experiment, 2)};
  std::vector<std::string> files;
  for (const Individual& parent : parents)
    files.push_back(
        folder.Write(parent.genotype.name + ".pls", Print(parent.genotype)));
  for (int id = 10; id < 30; ++id) {
    CAPTURE(id);
    const Individual child = CreateChild(experiment, 3, id, parents, {0, 0});
    const auto file = [&](std::size_t parent) {
      return files[static_cast<std::size_t>(child.heritage.parents[parent] -
                                            1)];
    };
    const auto ran =
        RunPlsc({"cross", file(0), file(1), "--seed", "7", "--generation", "3",
                 "--individual", std::to_string(id), "--format", "json"});
    REQUIRE(ran.exit == 0);
    const auto line = nlohmann::json::parse(ran.out);
    Genotype wanted = child.genotype;
    wanted.name = line["genotype"];
    CHECK(line["text"] == Print(wanted));
    CHECK(line["from_second"].size() == child.heritage.from_second.size());
  }
}

TEST_CASE("cross says which rules are whose", "[cli][cross]") {
  const test::TemporaryFolder folder;
  const std::string head = "plsc 1\nalphabet plasticoding 1\n";
  const std::string zoo = folder.Write(
      "zoo.pls", head +
                     "genotype a\nrule C -> { C B }\nrule B -> { B }\n"
                     "genotype b\nrule C -> { C T(1) }\nrule B -> { T(1) }\n");
  const auto ran = RunPlsc({"cross", zoo + "#a", zoo + "#b", "--seed", "3"});
  CHECK(ran.exit == 0);
  const auto child = Compile(Source("child", ran.out));
  REQUIRE(child);
  const bool has_second_b =
      child->genotype.rules[1].production[0].id == plasticoding::kT;
  const bool says_b = ran.err.find(" B") != std::string::npos;
  CHECK(has_second_b == says_b);
}

TEST_CASE("cross wants parents that fit", "[cli][cross]") {
  const test::TemporaryFolder folder;
  const std::string head = "plsc 1\nalphabet plasticoding 1\n";
  const std::string a = folder.Write("a.pls", head + "rule C -> { C B }\n");
  const std::string senses = folder.Write("b.pls", test::kPlasticText);
  const std::string own =
      folder.Write("c.pls", "plsc 1\nalphabet x { replaceable X }\naxiom X\n");
  const std::string strict =
      folder.Write("d.pls", head + "max_rules 1\nrule B -> { B }\n");
  const std::string lax =
      folder.Write("e.pls", head + "rule B -> { B }\nrule B -> { T(1) }\n");
  CHECK(RunPlsc({"cross", a, senses, "--seed", "1"}).exit == 1);
  CHECK(RunPlsc({"cross", a, own, "--seed", "1"}).exit == 1);
  CHECK(RunPlsc({"cross", a, folder / "none.pls", "--seed", "1"}).exit == 1);
  CHECK(RunPlsc({"cross", a, a}).exit == 2);
  CHECK(RunPlsc({"cross", a, lax, "--seed", "1", "-o", a}).exit == 1);
  int refused = 0;
  for (const char* seed : {"1", "2", "3", "4", "5", "6"})
    refused += RunPlsc({"cross", strict, lax, "--seed", seed}).exit;
  CHECK(refused > 0);
  CHECK(refused < 6);
}

}  // namespace
}  // namespace plsc
