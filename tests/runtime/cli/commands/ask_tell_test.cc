#include "runtime/cli/commands/ask_tell.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vector>

namespace plsc {
namespace {

using Json = nlohmann::json;

TEST_CASE("A request has an id or none, and a genotype", "[ask_tell]") {
  struct Row {
    const char* line;
    const char* id;
  };
  const std::vector<Row> rows = {
      {R"({"id": 7, "genotype": "g"})", "7"},
      {R"({"genotype": "g", "id": "a\"b"})", R"("a\"b")"},
      {R"({"id": -3, "genotype": "g"})", "-3"},
      {R"({"id": null, "genotype": "g"})", "null"},
      {R"({"genotype": "g"})", "null"},
  };
  for (const Row& row : rows) {
    INFO(row.line);
    const auto request =
        cli::ParseEvaluationRequest(Source("line", std::string(row.line)));
    REQUIRE(request);
    CHECK(request->id == row.id);
    CHECK(request->genotype == "g");
    CHECK(cli::IdOfRequest(row.line) == row.id);
  }
}

TEST_CASE("A wrong request is told with its place", "[ask_tell]") {
  struct Row {
    const char* why;
    std::string line;
    const char* code;
    const char* id;  ///< that can still be read
  };
  const std::vector<Row> rows = {
      {"no JSON", "genotype x", "P5100", "null"},
      {"cut off", R"({"id": 1, "genotype": "pl)", "P5100", "null"},
      {"a list", "[1]", "P5103", "null"},
      // The library would call itself a million times.
      {"an id of a million brackets",
       "{\"id\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']') +
           ", \"genotype\": \"g\"}",
       "P5100", "null"},
      {"no genotype", R"({"id": 1})", "P5106", "1"},
      {"a genotype that is no text", R"({"id": 1, "genotype": 2})", "P5103",
       "1"},
      {"an unknown key", R"({"id": 1, "genotype": "g", "seed": 2})", "P5101",
       "1"},
      {"an id that is a list", R"({"id": [1], "genotype": "g"})", "P5103",
       "null"},
      {"half an id", R"({"id": 1.5, "genotype": "g"})", "P5103", "null"},
      {"an id as long as a book",
       R"({"id": ")" + std::string(300, 'x') + R"(", "genotype": "g"})",
       "P5103", "null"},
      {"deep", std::string(100000, '['), "P5100", "null"},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    const auto request = cli::ParseEvaluationRequest(Source("line", row.line));
    REQUIRE_FALSE(request);
    CHECK(NumberOf(request.diagnostics()[0].code) == row.code);
    CHECK(cli::IdOfRequest(row.line) == row.id);
  }
}

TEST_CASE("An answer has the fitness of each season", "[ask_tell]") {
  Evaluation evaluation;
  evaluation.seasons.resize(2);
  evaluation.seasons[0].season = "flat";
  evaluation.seasons[0].fitness = 0.25;
  evaluation.seasons[1].season = "tilted";
  evaluation.seasons[1].sensed = {{"inclined", "False", SenseSource::kImu}};
  Genotype genotype;
  genotype.name = "g";
  genotype.states = {{"inclined", StateType::kBool, 0, 0, {}}};
  const Json answer =
      Json::parse(cli::EvaluationAnswer("\"x\"", genotype, evaluation));
  CHECK(answer["id"] == "x");
  CHECK(answer["fitness"]["flat"] == 0.25);
  CHECK(answer["fitness"]["tilted"].is_null());
  REQUIRE(answer["seasons"].size() == 2);
  CHECK(answer["seasons"][1]["season"] == "tilted");
  CHECK(answer["seasons"][1]["genotype"] == "g");
  CHECK(answer["seasons"][1]["sensed"]["inclined"]["value"] == false);
}

TEST_CASE("A failure has the request's line and the diagnostics",
          "[ask_tell]") {
  const Diagnostic diagnostic(Code::kArgumentRange, {7, 11},
                              "too \"much\"\xff");
  const Source source("text", "plsc 1\nrule");
  const Json answer = Json::parse(
      cli::FailureAnswer("4", 12, {diagnostic, diagnostic}, source));
  CHECK(answer["id"] == 4);
  CHECK(answer["line"] == 12);
  CHECK(answer["error"].get<std::string>().find("P2004: too \"much\"") == 0);
  REQUIRE(answer["diagnostics"].size() == 2);
  CHECK(answer["diagnostics"][0]["line"] == 2);
  const Json plain = Json::parse(cli::FailureAnswer("null", 1, "too long"));
  CHECK(plain["id"].is_null());
  CHECK(plain["error"] == "too long");
  CHECK(plain["diagnostics"].empty());
}

}  // namespace
}  // namespace plsc
