#include <catch2/catch.hpp>
#include <functional>
#include <nlohmann/json.hpp>

#include "runtime/recording/recording_json.h"
#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

using Json = nlohmann::ordered_json;

std::string ErrorsOf(const std::string& text) {
  const Source source("r.json", text);
  const Result<Recording> recording = ParseRecording(source);
  return recording ? "" : Render(recording.diagnostics(), source);
}

TEST_CASE("what is no recording is refused at its place", "[recording_parse]") {
  struct Row {
    const char* why;
    std::function<void(Json&)> spoil;
    const char* code;
    const char* message;
  };
  const auto season = [](Json& json) -> Json& { return json["seasons"][0]; };
  const std::vector<Row> rows = {
      {"a newer version", [](Json& j) { j["plsc_recording"] = 2; }, "P5002",
       "version 2"},
      {"no seasons", [](Json& j) { j.erase("seasons"); }, "P5106", "seasons"},
      {"an unknown key", [](Json& j) { j["saesons"] = 1; }, "P5101",
       "did you mean 'seasons'"},
      {"an unknown outcome", [&](Json& j) { season(j)["outcome"] = "bored"; },
       "P5107", "'bored'"},
      {"an unknown terrain",
       [&](Json& j) { season(j)["terrain"]["type"] = "swamp"; }, "P5107",
       "'swamp'"},
      {"a parameter of another terrain",
       [&](Json& j) { season(j)["terrain"]["tilt"] = 1; }, "P5101", "'tilt'"},
      {"a box of a module that is not there",
       [&](Json& j) {
         season(j)["body"]["links"][0]["boxes"][0]["module"] = 4;
       },
       "P5104", "0..3"},
      {"a link without mass",
       [&](Json& j) { season(j)["body"]["links"][0]["mass"] = 0; }, "P5104",
       "mass"},
      {"a centre of two numbers",
       [&](Json& j) {
         season(j)["body"]["links"][0]["rest"] = Json::array({1, 2});
       },
       "P5108", "expected 3 numbers for 'rest', found 2"},
      {"no quaternion",
       [&](Json& j) {
         season(j)["body"]["links"][0]["boxes"][0]["turn"][0] = 2;
       },
       "P5108", "length 1"},
      {"rows of another body",
       [&](Json& j) { season(j)["motion"]["position"]["rows"] = 3; }, "P5108",
       "expected 6 rows"},
      {"another unit",
       [&](Json& j) { season(j)["motion"]["position"]["unit"] = 1e-3; },
       "P5107", "'unit'"},
      {"data cut off",
       [&](Json& j) {
         auto& data = season(j)["motion"]["turn"]["data"];
         data = data.get<std::string>().substr(0, 400);
       },
       "P5108", "'data' is not 8 times 51 numbers"},
      {"more samples than data",
       [&](Json& j) { season(j)["motion"]["samples"] = 2000000000; }, "P5108",
       "'data' is not"},
      {"touch that is 3: the bytes 6 and 0",
       [&](Json& j) {
         season(j)["motion"]["touch"]["data"] =
             "BgAA" +
             season(j)["motion"]["touch"]["data"].get<std::string>().substr(4);
       },
       "P5104", "'touch' is 0 or 1"},
      {"steps of no time", [&](Json& j) { season(j)["motion"]["step"] = 0; },
       "P5104", "more than 0 s"},
      {"text for a number", [&](Json& j) { season(j)["begin"] = "soon"; },
       "P5103", "'begin'"},
  };
  static const std::string good = RecordingJson(test::SmallRecording());
  REQUIRE(ErrorsOf(good) == "");
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      Json json = Json::parse(good);
      row.spoil(json);
      const std::string errors = ErrorsOf(json.dump());
      INFO(errors.substr(0, 2000));
      CHECK(errors.find(row.code) != std::string::npos);
      CHECK(errors.find(row.message) != std::string::npos);
    }
  }
}

TEST_CASE("a recording cut off anywhere is refused", "[recording_parse]") {
  const std::string good = RecordingJson(test::SmallRecording());
  for (std::size_t size = 0; size + 1 < good.size(); size += 97) {
    INFO(size);
    CHECK(ErrorsOf(good.substr(0, size)) != "");
  }
}

}  // namespace
}  // namespace plsc
