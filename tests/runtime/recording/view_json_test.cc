#include "runtime/recording/view_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/recording/recording_json.h"
#include "tests/runtime/recording/recorded.h"

namespace plsc {
namespace {

TEST_CASE("a view holds recordings as their files have them", "[view_json]") {
  const Recording recording = test::SmallRecording();
  const nlohmann::json view = nlohmann::json::parse(ViewJson(
      {{"a.json", "", recording}, {"run, robot 2", "odd", recording}}));
  CHECK(view["plsc_view"] == 1);
  REQUIRE(view["lives"].size() == 2);
  CHECK(view["lives"][0]["source"] == "a.json");
  CHECK(view["lives"][1]["remark"] == "odd");
  CHECK(view["lives"][1]["recording"] ==
        nlohmann::json::parse(RecordingJson(recording)));
  CHECK(view["lives"][0]["grounds"].size() == recording.seasons.size());
}

TEST_CASE("names of files may be any bytes", "[view_json]") {
  const nlohmann::json view = nlohmann::json::parse(
      ViewJson({{"</script>\"\xff\n", "", test::SmallRecording()}}));
  CHECK(view["lives"][0]["source"] == "</script>\"\xef\xbf\xbd\n");
}

}  // namespace
}  // namespace plsc
