#include "runtime/cli/diagnostics/sarif.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using Json = nlohmann::json;

// What the schema of SARIF 2.1.0 requires of the objects that we write.
void CheckRegion(const Json& region) {
  for (const char* key : {"startLine", "startColumn", "endLine", "endColumn"})
    CHECK(region.at(key).get<int>() >= 1);
  CHECK(region.at("byteOffset").get<int>() >= 0);
  CHECK(region.at("byteLength").get<int>() >= 0);
}

void CheckLocation(const Json& location) {
  const Json& place = location.at("physicalLocation");
  CHECK(place.at("artifactLocation").at("uri").is_string());
  CheckRegion(place.at("region"));
}

void CheckResult(const Json& result, const Json& rules) {
  CHECK_FALSE(result.at("message").at("text").get<std::string>().empty());
  const std::string level = result.at("level");
  CHECK((level == "error" || level == "warning"));
  REQUIRE(result.at("locations").size() == 1);
  CheckLocation(result.at("locations")[0]);
  CHECK(rules.at(result.at("ruleIndex").get<std::size_t>()).at("id") ==
        result.at("ruleId"));
  for (const Json& related : result.value("relatedLocations", Json::array())) {
    CheckLocation(related);
    CHECK(related.at("message").at("text").is_string());
  }
  for (const Json& fix : result.value("fixes", Json::array())) {
    REQUIRE(fix.at("artifactChanges").size() == 1);
    const Json& change = fix.at("artifactChanges")[0];
    CHECK(change.at("artifactLocation").at("uri").is_string());
    REQUIRE_FALSE(change.at("replacements").empty());
    for (const Json& replacement : change.at("replacements")) {
      CheckRegion(replacement.at("deletedRegion"));
      CHECK(replacement.at("insertedContent").at("text").is_string());
    }
  }
}

void CheckDocument(const Json& document) {
  CHECK(document.at("version") == "2.1.0");
  CHECK(document.at("$schema").get<std::string>().find("sarif-schema-2.1.0") !=
        std::string::npos);
  REQUIRE(document.at("runs").size() == 1);
  const Json& run = document.at("runs")[0];
  CHECK(run.at("columnKind") == "unicodeCodePoints");
  const Json& driver = run.at("tool").at("driver");
  CHECK(driver.at("name") == "plsc");
  CHECK(driver.at("version").is_string());
  for (const Json& rule : driver.at("rules")) {
    CHECK(rule.at("id").get<std::string>().size() == 5);
    for (const char* key : {"shortDescription", "fullDescription", "help"})
      CHECK_FALSE(rule.at(key).at("text").get<std::string>().empty());
    CHECK(rule.at("defaultConfiguration").at("level").is_string());
  }
  for (const Json& result : run.at("results"))
    CheckResult(result, driver.at("rules"));
}

TEST_CASE("check --format sarif is SARIF of all files", "[sarif]") {
  const test::TemporaryFolder folder;
  const std::string head = "plsc 1\nalphabet plasticoding 1\n";
  const std::string a =
      folder.Write("a \xC3\xA9.pls", head + "rule B -> { B } rulle \n");
  const std::string b = folder.Write(
      "b.pls", head + "sense hot: bool\nrule B -> if hott = True then { B }\n");
  const auto ran =
      test::RunPlsc({"check", "--format", "sarif", a, b, folder / "none.pls"});
  CHECK(ran.exit == 1);
  CHECK(ran.err.empty());
  const Json document = Json::parse(ran.out);
  CheckDocument(document);
  const Json& results = document["runs"][0]["results"];
  REQUIRE(results.size() == 3);
  CHECK(results[0]["ruleId"] == "P1101");
  CHECK(
      results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
          .get<std::string>()
          .find("a%20%C3%A9.pls") != std::string::npos);
  CHECK(results[1]["ruleId"] == "P2005");
  CHECK(results[1]["relatedLocations"][0]["message"]["text"] ==
        "declared here");
  CHECK(results[1]["fixes"][0]["artifactChanges"][0]["replacements"][0]
               ["insertedContent"]["text"] == "hot");
  CHECK(results[2]["ruleId"] == "P5014");
}

TEST_CASE("SARIF of right files has no results", "[sarif]") {
  const auto ran =
      test::RunPlsc({"check", "--format", "sarif", "-"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  const Json document = Json::parse(ran.out);
  CheckDocument(document);
  CHECK(document["runs"][0]["results"].empty());
}

TEST_CASE("Columns of SARIF count code points, ends are behind", "[sarif]") {
  // Behind a robot's face of four bytes.
  Diagnostic diagnostic(Code::kUnknownItem, {5, 7}, "odd \xFF bytes");
  diagnostic.severity = Severity::kWarning;
  const Json document = Json::parse(
      cli::Sarif({{Source("a", "\xF0\x9F\xA4\x96 xy\n"), {diagnostic}}}));
  CheckDocument(document);
  const Json& result = document["runs"][0]["results"][0];
  CHECK(result["level"] == "warning");
  const Json& region = result["locations"][0]["physicalLocation"]["region"];
  CHECK(region["startColumn"] == 3);
  CHECK(region["endColumn"] == 5);
  CHECK(region["byteOffset"] == 5);
  CHECK(region["byteLength"] == 2);
}

}  // namespace
}  // namespace plsc
