#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/print.h"
#include "runtime/evolve/experiment.h"
#include "runtime/store/database.h"
#include "runtime/store/export.h"
#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

using nlohmann::json;

struct Lines {
  std::string failure;
  std::string text;
  std::vector<json> objects;
};

Lines Export(const std::string& run) {
  Lines lines;
  lines.failure = WriteJsonl(run,
                             [&](std::string_view piece) {
                               lines.text += piece;
                               return std::nullopt;
                             })
                      .value_or("")
                      .text;
  std::istringstream text(lines.text);
  for (std::string line; std::getline(text, line);)
    lines.objects.push_back(json::parse(line));
  return lines;
}

}  // namespace

TEST_CASE("Lines have the run, everybody and every generation", "[export]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run");
  const test::Recorder run = test::RecordRun(test::StoredExperiment());
  const Lines lines = Export(scratch / "run");
  CHECK(lines.failure.empty());
  REQUIRE(lines.objects.size() == 1 + 32 + 5);
  const json& head = lines.objects[0]["run"];
  CHECK(head["name"] == "stored");
  CHECK(head["seed"] == "18364758544493064720");
  CHECK(head["versions"]["machine"] == ThisProgram().machine);
  const auto read =
      ParseExperiment(Source("run", head["experiment"].get<std::string>()));
  REQUIRE(read);
  CHECK(*read == test::StoredExperiment());
  for (std::size_t i = 0; i < 32; ++i) {
    const json& one = lines.objects[1 + i]["individual"];
    const Individual& individual = run.individuals[i];
    CHECK(one["id"] == i + 1);
    CHECK(one["parents"] == json(individual.heritage.parents));
    if (individual.heritage.mutation)
      CHECK(one["mutated_rule"] == individual.heritage.mutation->rule + 1);
    CHECK(one["genotype"] == Print(individual.genotype));
    REQUIRE(one["seasons"].size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
      const SeasonResult& season = individual.evaluation.seasons[k];
      CHECK(one["seasons"][k]["season"] == season.season);
      if (!season.sensed.empty()) {
        CHECK(one["seasons"][k]["sensed"]["inclined"]["value"] ==
              (season.sensed[0].value == "True"));
        CHECK(one["seasons"][k]["sensed"]["heat"]["value"].is_number());
      }
      if (season.fitness)
        CHECK(one["seasons"][k]["fitness"] == *season.fitness);
      else
        CHECK(one["seasons"][k]["fitness"].is_null());
    }
  }
  for (std::size_t g = 0; g < 5; ++g) {
    const json& record = lines.objects[33 + g];
    CHECK(record["generation"] == g);
    CHECK(record["best"] == run.generations[g].best);
    CHECK(record["pool"] == json(run.generations[g].pool));
    CHECK(record["counts"] == json(run.generations[g].counts));
    CHECK(record["survivors"] == json(run.generations[g].survivors));
  }
}

TEST_CASE("What a damaged run still has is written", "[export]") {
  const test::Scratch scratch;
  test::WriteRun(scratch / "run");
  {
    Database database;
    REQUIRE(database.Open(scratch / "run", Database::Mode::kWrite) ==
            std::nullopt);
    database.Run("UPDATE evaluation SET outcome = 'what' WHERE individual = 7");
    REQUIRE(database.TakeFailure() == std::nullopt);
  }
  const Lines lines = Export(scratch / "run");
  CHECK(lines.failure == "'" + (scratch / "run") +
                             "' is damaged: the evaluation of robot 7 is not "
                             "what it was");
  CHECK(lines.objects.size() == 1 + 31 + 5);
  CHECK(Export(scratch / "none").failure.find("No such file") !=
        std::string::npos);
}

}  // namespace plsc
