#include <catch2/catch.hpp>

#include "compiler/named_environments.h"
#include "runtime/history/explained_robot.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

// That pictures are those of `plsc draw`, the tests of the commands compare
// (tests/runtime/cli/same_answers_test.cc).

TEST_CASE("robots are explained as on the page of 'plsc view --explain'",
          "[service]") {
  for (const auto& [name, text] : test::ExampleTexts()) {
    INFO(name);
    const Source source(name, text);
    const auto mapped = CompileWithMap(source);
    REQUIRE(mapped);
    const Program& program = mapped->program;
    if (!program.genotype.alphabet->is_built_in()) continue;
    const auto explained = ExplainRobot(program.genotype.name, source, *mapped,
                                        *UsualEnvironments(program));
    REQUIRE(explained);
    const std::string answer = test::AnsweredText(
        {{"ask", "explain"}, {"name", name}, {"text", text}});
    CHECK(answer == R"({"id":null,"ask":"explain","ok":true,"explained":)" +
                        ExplainJson({*explained}) + "}");
  }
}

TEST_CASE("a robot is explained and drawn in the same environments",
          "[service]") {
  const std::string text = test::ExampleText("climber.pls");
  const OrderedJson explained =
      test::Answered({{"ask", "explain"}, {"text", text}});
  const OrderedJson& robot = explained["explained"]["robots"][0];
  CHECK(robot["title"] == "climber");
  CHECK(robot["environments"].size() == 2);
  const OrderedJson drawn =
      test::Answered({{"ask", "picture"}, {"text", text}});
  for (const char* key : {"body", "rules", "brain"}) {
    const std::string svg = drawn[key];
    CHECK(svg.starts_with("<svg"));
    CHECK(svg.find("flat") != std::string::npos);
    CHECK(svg.find("tilted") != std::string::npos);
  }
  const std::string one = test::Answered(
      {{"ask", "picture"}, {"text", text}, {"environment", "tilted"}})["body"];
  CHECK(one.find("flat") == std::string::npos);
}

TEST_CASE("what has no body, or too much of a history, is not shown",
          "[service]") {
  const std::string didactic = test::ExampleText("didactic.pls");
  for (const char* ask : {"explain", "picture"})
    CHECK(test::WordsOf({{"ask", ask}, {"text", didactic}}) ==
          "alphabet 'didactic' has no bodies to show");
  std::string text =
      "plsc 1\nalphabet plasticoding 1\nrule C -> { C B }\nrule B -> {";
  for (int i = 0; i < 200; ++i) text += " B";
  text += " }\n";
  CHECK(test::WordsOf({{"ask", "explain"}, {"text", text}}) ==
        "the rewritings of unnamed have more than 20000 symbols, too many for "
        "a page");
  CHECK(test::Answered({{"ask", "picture"}, {"text", text}})["ok"] == true);
}

}  // namespace
}  // namespace plsc
