#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "compiler/format.h"
#include "runtime/advice/lint.h"
#include "runtime/text/diagnostic_json.h"
#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

TEST_CASE("check finds what 'plsc check --lint' finds", "[service]") {
  auto texts = test::ExampleTexts();
  for (const char* broken :
       {"plsc 1\nalphabet plasticoding 1\nrul C -> C\n", "", "\t\x01 \u00e4",
        "plsc 1\nalphabet plasticoding 1\nrule B -> { B }\nrule C -> { C A1(9) "
        "}\n",
        "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
        "rule C -> if a = True and a = False then { C B }\n"})
    texts.emplace_back("broken.pls", broken);
  for (const auto& [name, text] : texts) {
    INFO(name << "\n" << text);
    const Source source(name, text);
    const auto compiled = CompileAllWithMap(source);
    std::vector<Diagnostic> found = compiled.diagnostics();
    if (compiled)
      for (const Diagnostic& warning : Lint(*compiled, source))
        found.push_back(warning);
    const std::string answer = test::AnsweredText(
        {{"ask", "check"}, {"name", name}, {"text", text}, {"lint", true}});
    CHECK(test::HoldsBytes(
        answer, "\"diagnostics\":[" + DiagnosticsJson(found, source) + "]"));
    const auto json = OrderedJson::parse(answer);
    CHECK(json["fine"] == static_cast<bool>(compiled));
    REQUIRE(json["genotypes"].size() == (compiled ? compiled->size() : 0));
    for (std::size_t i = 0; i < json["genotypes"].size(); ++i) {
      const Program& program = (*compiled)[i].program;
      const OrderedJson& one = json["genotypes"][i];
      CHECK(one["name"] == program.genotype.name);
      CHECK(one["states"].size() == program.genotype.states.size());
      REQUIRE(one["environments"].size() == program.environments.size());
      for (std::size_t k = 0; k < program.environments.size(); ++k)
        CHECK(one["environments"][k]["name"] == program.environments[k].name);
    }
  }
}

TEST_CASE("check tells what a robot can sense", "[service]") {
  const OrderedJson answer = test::Answered(
      {{"ask", "check"},
       {"text",
        "plsc 1\nalphabet plasticoding 1\nsense wet: bool\n"
        "sense heat: real in -10.0..30.0\nsense ground: { sand, rock }\n"
        "environment a { wet = True, heat = 2.5, ground = rock }\n"
        "rule C -> { C }\n"}});
  const OrderedJson& one = answer["genotypes"][0];
  INFO(answer.dump());
  CHECK(one["states"][0] == OrderedJson({{"name", "wet"}, {"type", "bool"}}));
  CHECK(one["states"][1] == OrderedJson({{"name", "heat"},
                                         {"type", "real"},
                                         {"low", -10.0},
                                         {"high", 30.0}}));
  CHECK(one["states"][2]["values"] == OrderedJson::array({"sand", "rock"}));
  CHECK(one["environments"][0]["senses"] ==
        OrderedJson({{"wet", true}, {"heat", 2.5}, {"ground", "rock"}}));
  CHECK(one["has_bodies"] == true);
}

TEST_CASE("format gives what 'plsc fmt' writes", "[service]") {
  for (auto [name, text] : test::ExampleTexts()) {
    text += "\n\n   # the end\n";
    const auto formatted = Format(Source(name, text));
    REQUIRE(formatted);
    const OrderedJson answer =
        test::Answered({{"ask", "format"}, {"text", text}});
    CHECK(answer["text"] == *formatted);
    CHECK(answer["changed"] == (*formatted != text));
    const OrderedJson again =
        test::Answered({{"ask", "format"}, {"text", *formatted}});
    CHECK(again["changed"] == false);
  }
}

TEST_CASE("what does not compile is not formatted", "[service]") {
  const std::string text = "plsc 1\nalphabet plasticoding 1\nrul C -> C\n";
  const OrderedJson answer =
      test::Answered({{"ask", "format"}, {"name", "a.pls"}, {"text", text}});
  CHECK(answer["ok"] == false);
  CHECK(answer["diagnostics"][0]["file"] == "a.pls");
  CHECK(answer["diagnostics"][0]["line"] == 3);
  CHECK(answer["error"] ==
        answer["diagnostics"][0]["code"].get<std::string>() + ": " +
            answer["diagnostics"][0]["message"].get<std::string>());
}

}  // namespace
}  // namespace plsc
