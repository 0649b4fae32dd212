#include <catch2/catch.hpp>

#include "tests/runtime/service/asked.h"

namespace plsc {
namespace {

using test::OrderedJson;

constexpr const char* kFew =
    "plsc 1\nalphabet plasticoding 1\n# \u00e4\u00f6\n"
    "rule C -> { C add_front A1(0.5, 2.5, 3, 1) mutate_amp(0.25) }\n";

TEST_CASE("parameters have their places and bounds", "[service]") {
  const OrderedJson answer =
      test::Answered({{"ask", "parameters"}, {"text", kFew}});
  const OrderedJson& all = answer["parameters"];
  REQUIRE(all.size() == 5);
  const OrderedJson& amplitude = all[1];
  CHECK(amplitude["kind"] == "argument");
  CHECK(amplitude["name"] == "a of A1");
  CHECK(amplitude["line"] == 4);
  CHECK(amplitude["column"] == 33);
  const std::string text = kFew;
  const std::size_t begin = amplitude["byte_begin"];
  CHECK(text.substr(begin, amplitude["byte_end"].get<std::size_t>() - begin) ==
        "2.5");
  CHECK(amplitude["value"] == 2.5);
  CHECK(amplitude["whole"] == false);
  CHECK(amplitude["lowest"] == 1.0);
  CHECK(amplitude["highest"] == 10.0);
  CHECK(amplitude["from"] == 1.0);
  CHECK(amplitude["step"] == 0.1);
  CHECK(all[4]["lowest"].is_null());
}

TEST_CASE("the parameter at a place is the one there", "[service]") {
  const auto at = [](int line, int column) {
    return test::Answered({{"ask", "parameters"},
                           {"text", kFew},
                           {"at", {{"line", line}, {"column", column}}}});
  };
  const OrderedJson one = at(4, 34);
  REQUIRE(one["parameters"].size() == 1);
  CHECK(one["parameters"][0]["name"] == "a of A1");
  CHECK(at(1, 1)["parameters"].empty());
  CHECK(at(9, 1)["error"] == "the text has no line 9 with a column 1");
  CHECK(at(0, 1)["ok"] == false);
}

TEST_CASE("of a text of too many numbers one can be asked for", "[service]") {
  std::string text = "plsc 1\nalphabet plasticoding 1\nrule C -> { C";
  for (int i = 0; i < 2600; ++i) text += "\nA1(0.5, 2, 3, 1)";
  text += " }\n";
  CHECK(test::WordsOf({{"ask", "parameters"}, {"text", text}}) ==
        "the text has 10400 numbers, more than 10000; ask for the one at a "
        "place");
  CHECK(test::Answered({{"ask", "parameters"},
                        {"text", text},
                        {"at", {{"line", 4}, {"column", 5}}}})["parameters"]
            .size() == 1);
}

}  // namespace
}  // namespace plsc
