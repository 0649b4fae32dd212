#include "runtime/compare/golden_json.h"

#include <catch2/catch.hpp>

#include "tests/runtime/compare/golden_sample.h"

namespace plsc {
namespace {

Golden Sample() {
  Golden golden;
  golden.descriptor_tolerance = 1e-6;
  golden.cases.push_back({"tilted", test::GoldenSample()});
  golden.cases.push_back({"inclined=True", std::nullopt});
  Observation text;  // of an alphabet without bodies, a long string
  text.active_rules = {};
  text.string = {{"X", "Y(0.1, -0)"}, 1000, "0123456789abcdef"};
  golden.cases.push_back({"any", text});
  return golden;
}

TEST_CASE("a golden file reads back as it was written", "[golden]") {
  const std::string text = PrintGolden(Sample());
  const Source source("test", text);
  const Result<Golden> read = ParseGolden(source);
  INFO(Render(read.diagnostics(), source));
  REQUIRE(read);
  CHECK(*read == Sample());
  CHECK(PrintGolden(*read) == text);
}

TEST_CASE("numbers read back to the last bit", "[golden]") {
  for (const double value : {0.1 + 0.2, 1e-300, -0.3333333333333333, 1e20}) {
    Golden golden = Sample();
    golden.cases[0].expected->robot->nodes[0].weight = value;
    golden.cases[0].expected->robot->edges[0].weight = value;
    golden.cases[0].expected->robot->body_descriptors[0].second = value;
    const Source source("test", PrintGolden(golden));
    const Result<Golden> read = ParseGolden(source);
    REQUIRE(read);
    CHECK(*read == golden);
  }
}

TEST_CASE("a golden file has one fact a line", "[golden]") {
  const std::string text = PrintGolden(Sample());
  const auto has = [&](const char* line) {
    return text.find(std::string("\n") + line + "\n") != std::string::npos;
  };
  CHECK(has("  \"plsc_golden\": 1,"));
  CHECK(has("      \"environment\": \"tilted\","));
  CHECK(has("        \"add_front\","));
  CHECK(
      has("        {\"id\": \"5\", \"type\": \"A2\", \"parent\": \"1\", "
          "\"slot\": \"right\", \"x\": 1, \"y\": 0, \"facing\": \"right\", "
          "\"angle\": 0},"));
  CHECK(
      has("        {\"from\": \"node3\", \"to\": \"node1\", \"weight\": "
          "0.5},"));
  CHECK(has("        \"width\": 5"));
  CHECK(text.ends_with("}\n"));
}

TEST_CASE("hostile names survive", "[golden]") {
  Golden golden = Sample();
  golden.cases[1].environment = "a=\"b\\\n\x01,\xC3\xA9=1";
  const Source source("test", PrintGolden(golden));
  const Result<Golden> read = ParseGolden(source);
  REQUIRE(read);
  CHECK(*read == golden);
}

}  // namespace
}  // namespace plsc
