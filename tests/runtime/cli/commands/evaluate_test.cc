// `plsc evaluate` in this process; examples/one_plus_one.py drives the program
// through pipes (tests/examples).

#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;

const char* const kScenario = R"(plsc_scenario: 1
name: short
seasons:
  - {name: flat, terrain: flat, duration: 1 s}
  - {name: tilted, terrain: {tilted: 5 deg}, duration: 1 s}
)";

std::string Request(const Json& id, const std::string& genotype) {
  return Json{{"id", id}, {"genotype", genotype}}.dump() + "\n";
}

std::vector<Json> AnswerLines(const std::string& text) {
  std::vector<Json> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(Json::parse(line));
  return lines;
}

/// plsc evaluate --stdin with the short scenario.
class Evaluated {
 public:
  explicit Evaluated(const std::string& input,
                     std::vector<std::string> options = {}) {
    std::vector<std::string> arguments{"evaluate", "--stdin", "--scenario",
                                       folder_.Write("short.yaml", kScenario)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    ran = test::RunPlsc(arguments, input);
    answers = AnswerLines(ran.out);
  }
  /// The answer to the request of that id.
  const Json& of(const Json& id) const {
    for (const Json& answer : answers)
      if (answer["id"] == id) return answer;
    throw std::runtime_error("no answer to " + id.dump());
  }

  test::Ran ran;
  std::vector<Json> answers;

 private:
  test::TemporaryFolder folder_;
};

TEST_CASE("An answer is what simulate prints", "[evaluate]") {
  const test::TemporaryFolder folder;
  const Evaluated evaluated(Request("a", test::kPlasticText));
  CHECK(evaluated.ran.exit == 0);
  CHECK(evaluated.ran.err.empty());
  REQUIRE(evaluated.answers.size() == 1);
  const Json& answer = evaluated.of("a");
  const auto simulated = AnswerLines(
      test::RunPlsc({"simulate", folder.Write("robot.pls", test::kPlasticText),
                     "--scenario", folder.Write("short.yaml", kScenario),
                     "--format", "json"})
          .out);
  CHECK(answer["seasons"] == Json(simulated));
  REQUIRE(simulated.size() == 2);
  CHECK(answer["fitness"]["flat"] == simulated[0]["fitness"]);
  CHECK(answer["fitness"]["tilted"] == simulated[1]["fitness"]);
}

TEST_CASE("Answers do not depend on the workers", "[evaluate]") {
  std::string input;
  for (int i = 0; i < 12; ++i)
    input += Request(
        i, test::RunPlsc({"random", "--seed", std::to_string(i + 1)}).out);
  const Evaluated one(input, {"--jobs", "1", "--in-order"});
  const Evaluated three(input, {"--jobs", "3", "--in-order"});
  const Evaluated any(input, {"--jobs", "3"});
  CHECK(one.ran.exit == 0);
  CHECK(one.ran.out == three.ran.out);
  REQUIRE(one.answers.size() == 12);
  REQUIRE(any.answers.size() == 12);
  for (int i = 0; i < 12; ++i) {
    CHECK(one.answers[static_cast<std::size_t>(i)]["id"] == i);
    CHECK(any.of(i) == one.of(i));
  }
}

TEST_CASE("What is wrong is answered, and the others go on", "[evaluate]") {
  const std::string good = test::kPlasticText;
  const std::string alphabet =
      "plsc 1\ngenotype g\nalphabet own { replaceable S; terminal x }\n"
      "axiom S\niterations 1\nrule S -> { S x }\n";
  const std::string unknown =
      "plsc 1\ngenotype g\nalphabet plasticoding 1\nsense hot: bool\n"
      "rule C -> if hot = True then { C }\n";
  const std::string wide =
      "plsc 1\ngenotype g\nalphabet plasticoding 1\n"
      "rule C -> { C add_front A1(0.5, 20, 2, 2) }\n";
  const std::string input =
      Request("first", good) + "\n" + Request("broken", "plsc 1\ngenotype") +
      "{\"id\": \"keys\"}\nnot json\n" + Request("hot", unknown) +
      Request("wide", wide) + "  \r\n" + Request("last", good);
  const Evaluated evaluated(input);
  CHECK(evaluated.ran.exit == 1);
  CHECK(evaluated.answers.size() == 7);
  CHECK(evaluated.of("last")["seasons"] == evaluated.of("first")["seasons"]);
  struct Row {
    Json id;
    int line;
    const char* told;
  };
  const std::vector<Row> rows = {
      {"broken", 3, "P1102"}, {"keys", 4, "P5106"}, {nullptr, 5, "P5100"},
      {"hot", 6, "hot"},      {"wide", 7, "P2004"},
  };
  for (const Row& row : rows) {
    INFO(row.id);
    const Json& answer = evaluated.of(row.id);
    CHECK(answer["line"] == row.line);
    CHECK(answer["error"].get<std::string>().find(row.told) !=
          std::string::npos);
    CHECK_FALSE(answer["diagnostics"].empty());
    CHECK_FALSE(answer.contains("fitness"));
  }
  const Evaluated allowed(Request("wide", wide), {"--allow-range"});
  CHECK(allowed.ran.exit == 0);
  CHECK(allowed.of("wide").contains("fitness"));
  const Evaluated own(Request("own", alphabet));
  CHECK(own.ran.exit == 1);
  CHECK(own.of("own")["error"] == "alphabet 'own' has no bodies to simulate");
}

TEST_CASE("Nothing is asked, nothing is answered", "[evaluate]") {
  const Evaluated evaluated("");
  CHECK(evaluated.ran.exit == 0);
  CHECK(evaluated.ran.out.empty());
}

TEST_CASE("The command line is checked before anything is read", "[evaluate]") {
  CHECK(test::RunPlsc({"evaluate"}).exit == 2);
  CHECK(test::RunPlsc({"evaluate", "--stdin", "--jobs", "-1"}).exit == 2);
  CHECK(test::RunPlsc({"evaluate", "--stdin", "--scenario", "none.yaml"},
                      Request(1, test::kPlasticText))
            .exit == 1);
}

}  // namespace
}  // namespace plsc
