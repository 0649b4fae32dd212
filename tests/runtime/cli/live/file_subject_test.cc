#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/cli/live/subject.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc::cli {
namespace {

using Value = nlohmann::json;

server::Response Saved(Subject& subject, const std::string& body) {
  server::Request request;
  request.method = "POST";
  request.target = "save";
  request.body = body;
  return subject.Answer(request);
}

TEST_CASE("a page of a file has its text, and hears of changes",
          "[file_subject]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a <b>.pls", "one");
  const std::string scenario = folder.Write("s.yaml", "seasons: []");
  auto joined = JoinFile(path, scenario);
  REQUIRE(joined);
  Subject& subject = **joined;
  CHECK(subject.Title() == "a <b>.pls");
  const Value data = Value::parse(subject.PageData());
  CHECK(data["robot"] == "one");
  CHECK(data["scenario"] == "seasons: []");
  CHECK(data["follow"] == "file");
  CHECK(subject.Standing().size() == 2);
  CHECK(subject.Look().empty());
  folder.Write("a <b>.pls", "two\n\xff");
  const auto events = subject.Look();
  REQUIRE(events.size() == 1);
  CHECK(events[0].first == "file");
  CHECK(events[0].second.find('\n') == std::string::npos);
  CHECK(Value::parse(events[0].second)["text"] == "two\n\xef\xbf\xbd");
}

TEST_CASE("a page saves, or is told of the conflict", "[file_subject]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "one");
  auto joined = JoinFile(path, "");
  REQUIRE(joined);
  Subject& subject = **joined;
  const std::string version =
      Value::parse(subject.PageData())["server"]["file"];
  const auto body = [](const std::string& text, const std::string& of) {
    return Value{{"text", text}, {"version", of}}.dump();
  };
  const Value saved = Value::parse(Saved(subject, body("two", version)).body);
  CHECK(saved["ok"] == true);
  CHECK(saved["version"] != version);
  const auto refused = Saved(subject, body("three", version));
  CHECK(refused.status == 200);  // browsers complain of others by themselves
  const Value conflict = Value::parse(refused.body);
  CHECK(conflict["ok"] == false);
  CHECK(conflict["conflict"]["text"] == "two");
  CHECK(conflict["conflict"]["version"] == saved["version"]);
  CHECK(test::ReadFile(path) == "two");
}

TEST_CASE("nonsense is not saved", "[file_subject]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "one");
  auto joined = JoinFile(path, "");
  REQUIRE(joined);
  const std::string body = GENERATE(
      "", "{", "[]", "null", R"({"text": "x"})", R"({"version": "x"})",
      R"({"text": 1, "version": ""})", R"({"text": "x", "version": null})");
  CHECK(Saved(**joined, body).status == 400);
  CHECK(test::ReadFile(path) == "one");
  server::Request other;
  other.method = "GET";
  other.target = GENERATE("etc/passwd", "../a.pls", "a.pls", "robot");
  CHECK((*joined)->Answer(other).status == 404);
  other.target = "save";
  CHECK((*joined)->Answer(other).status == 405);
}

TEST_CASE("what cannot be read is refused at the start", "[file_subject]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "one");
  CHECK_FALSE(JoinFile(folder / "none.pls", ""));
  CHECK_FALSE(JoinFile(path, folder / "none.yaml"));
}

}  // namespace
}  // namespace plsc::cli
