#include <catch2/catch.hpp>

#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

TEST_CASE("two versions of a text are compared", "[service]") {
  for (const auto& [name, text] : test::ExampleTexts()) {
    INFO(name);
    const OrderedJson same = test::Answered(
        {{"ask", "compare"}, {"before", text}, {"text", text + "# end\n"}});
    CHECK(same["difference"]["differs"] == false);
    CHECK(same["difference"]["texts"].empty());
  }
  const std::string before = test::ExampleText("gecko.pls");
  std::string after = before;
  after.replace(after.rfind("1.0)"), 3, "1.25");
  const OrderedJson other =
      test::Answered({{"ask", "compare"}, {"before", before}, {"text", after}});
  CHECK(other["difference"]["differs"] == true);
  CHECK(other["difference"]["robots"].size() == 1);
}

TEST_CASE("either version may be wrong", "[service]") {
  const std::string text = test::ExampleText("gecko.pls");
  const OrderedJson before =
      test::Answered({{"ask", "compare"}, {"before", "no"}, {"text", text}});
  CHECK(before["diagnostics"][0]["file"] == "robot.pls before");
  const OrderedJson after =
      test::Answered({{"ask", "compare"}, {"before", text}, {"text", "no"}});
  CHECK(after["diagnostics"][0]["file"] == "robot.pls");
}

TEST_CASE("robots that grow beyond the limits are not compared", "[service]") {
  std::string text = "plsc 1\nalphabet plasticoding 1\niterations ";
  std::string rules = "\nrule C -> { C B }\nrule B -> {";
  for (int i = 0; i < 40; ++i) rules += " B";
  rules += " }\n";
  for (const char* iterations : {"4", "6", "100"})
    CHECK(test::WordsOf({{"ask", "compare"},
                         {"before", text + iterations + rules},
                         {"text", text + iterations + rules}}) ==
          "to compare the robots takes more than 131072 symbols");
}

}  // namespace
}  // namespace plsc
