// The authors' own results, through the command that users type. The one test
// that says that development is theirs.

#include <catch2/catch.hpp>
#include <sstream>

#include "runtime/cli/run.h"
#include "tests/runtime/develop/reference_cases.h"
#include "tests/sanitizer.h"

namespace plsc {
namespace {

using test::Json;

// Descriptors only: the order of summation differs from the authors'.
constexpr double kRelativeTolerance = 1e-12;

// Empty when equal; else the path of the first difference and both values.
std::string Difference(const Json& expected, const Json& actual,
                       double tolerance, const std::string& path = "") {
  const auto differs = [&] {
    return path + ": expected " + expected.dump() + ", got " + actual.dump();
  };
  if (expected.is_number() && actual.is_number()) {
    const double e = expected.get<double>();
    const double a = actual.get<double>();
    const double allowed = tolerance * std::abs(e);
    return std::abs(e - a) <= allowed ? "" : differs();
  }
  if (expected.type() != actual.type()) return differs();
  if (expected.is_array()) {
    if (expected.size() != actual.size()) return differs();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const std::string inner =
          Difference(expected[i], actual[i], tolerance,
                     path + "[" + std::to_string(i) + "]");
      if (!inner.empty()) return inner;
    }
    return "";
  }
  if (expected.is_object()) {
    if (expected.size() != actual.size()) return differs();
    for (const auto& [key, value] : expected.items()) {
      if (!actual.contains(key)) return path + "." + key + ": missing";
      const std::string inner =
          Difference(value, actual[key], tolerance, path + "." + key);
      if (!inner.empty()) return inner;
    }
    return "";
  }
  return expected == actual ? "" : differs();
}

Json DevelopWithCommand(const Json& reference_case) {
  std::istringstream in(test::GenotypeText(reference_case));
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const cli::Exit exit =
      cli::Main({"develop", "-", "--env", test::EnvironmentText(reference_case),
                 "--format", "json"},
                io);
  INFO(err.str());
  REQUIRE(exit == cli::Exit::kFine);
  return Json::parse(out.str());
}

void CheckSet(const std::string& set, std::size_t expected_cases) {
  const std::vector<Json> cases = test::ReadReferenceCases(set);
  CHECK(cases.size() == expected_cases);
  for (std::size_t i = 0; i < cases.size(); i += test::kSparser) {
    const Json& reference_case = cases[i];
    INFO(reference_case["id"]);
    const Json actual = DevelopWithCommand(reference_case);
    const Json& expected = reference_case["expected"];
    for (const char* exact : {"early", "body", "brain"})
      CHECK(Difference(expected[exact], actual[exact], 0) == "");
    for (const char* close : {"body_descriptors", "brain_descriptors"})
      CHECK(Difference(expected[close], actual[close], kRelativeTolerance) ==
            "");
  }
}

TEST_CASE("plsc develop reproduces the authors' plastic robots",
          "[reference]") {
  CheckSet("sample_plastic", 300);
}
TEST_CASE("plsc develop reproduces the authors' baseline robots",
          "[reference]") {
  CheckSet("sample_baseline", 80);
}
TEST_CASE("plsc develop reproduces the authors' robots with two states",
          "[reference]") {
  CheckSet("sample_two_states", 160);
}
TEST_CASE("plsc develop reproduces the authors' rare cases", "[reference]") {
  CheckSet("sample_rare", 9);
}

TEST_CASE("the comparison of reference cases notices any difference",
          "[reference]") {
  const Json a = Json::parse(R"({"x": [1.0, {"y": "z"}], "n": null})");
  CHECK(Difference(a, a, 0) == "");
  CHECK(Difference(a, Json::parse(R"({"x": [1.0000000000000002, {"y": "z"}],
                                      "n": null})"),
                   0) != "");
  CHECK(Difference(a, Json::parse(R"({"x": [1.0, {"y": "w"}], "n": null})"),
                   1) != "");
  CHECK(Difference(a, Json::parse(R"({"x": [1.0, {"y": "z"}], "n": 0})"), 1) !=
        "");
  CHECK(Difference(a, Json::parse(R"({"x": [1.0, {}], "n": null})"), 1) != "");
}

}  // namespace
}  // namespace plsc
