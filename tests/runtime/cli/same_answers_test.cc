// What the service answers is what the commands print and write, byte for byte,
// of every example.

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "runtime/service/service.h"
#include "runtime/text/version.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc::test {
namespace {

using Asked = nlohmann::ordered_json;

std::string AnswerTo(const Asked& request) {
  Service service(kVersion);
  return service.Answer(request.dump());
}

std::vector<std::string> ExampleFiles() {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(InRepository("examples")))
    if (entry.path().extension() == ".pls")
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 6);
  return files;
}

bool HasBodies(const std::string& text) {
  return text.find("alphabet plasticoding") != std::string::npos;
}

/// The lines of a command's output, each a JSON object, as a list has them.
std::string Listed(const std::string& lines) {
  std::string list = lines;
  if (!list.empty()) list.pop_back();
  std::replace(list.begin(), list.end(), '\n', ',');
  return list;
}

void CheckHolds(const std::string& answer, const std::string& part) {
  const bool is_held = answer.find(part) != std::string::npos;
  INFO("not in the answer: " << part.substr(0, 400));
  CHECK(is_held);
}

TEST_CASE("the service checks, formats and develops as the commands do",
          "[cli][service]") {
  for (const std::string& file : ExampleFiles()) {
    INFO(file);
    const std::string text = ReadFile(file);
    const Ran checked = RunPlsc({"check", "--lint", "--format", "json", file});
    CheckHolds(
        AnswerTo(
            {{"ask", "check"}, {"name", file}, {"text", text}, {"lint", true}}),
        "\"diagnostics\":[" + Listed(checked.out) + "]");
    const Ran formatted = RunPlsc({"fmt", "--stdout", file});
    REQUIRE(formatted.exit == 0);
    CheckHolds(AnswerTo({{"ask", "format"}, {"text", text}}),
               "\"text\":" + Asked(formatted.out).dump());
    const Ran developed = RunPlsc({"develop", "--format", "json", file});
    REQUIRE(developed.exit == 0);
    const Asked answer =
        Asked::parse(AnswerTo({{"ask", "develop"}, {"text", text}}));
    std::string lines;
    for (const Asked& one : answer["environments"])
      lines += one["development"].dump() + "\n";
    CHECK(lines == developed.out);
  }
}

TEST_CASE("diagnostics of the service are those of check", "[cli][service]") {
  const TemporaryFolder folder;
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nrul C -> { C }\n"
      "rule C -> { C add_frnt A1(0.5, 20, 3, 1) }\n";
  const std::string file = folder.Write("broken.pls", text);
  const Ran checked = RunPlsc({"check", "--format", "json", file});
  CHECK(checked.exit == 1);
  CheckHolds(AnswerTo({{"ask", "check"}, {"name", file}, {"text", text}}),
             "\"fine\":false,\"diagnostics\":[" + Listed(checked.out) + "]");
}

TEST_CASE("the service lives and records as the commands do",
          "[cli][service]") {
  const TemporaryFolder folder;
  const std::string yaml =
      "plsc_scenario: 1\nseasons:\n"
      "  - {name: level, terrain: flat, duration: 0.3 s, "
      "senses: {hot: False}}\n"
      "  - {name: hill, terrain: {tilted: 5 deg}, duration: 0.3 s, "
      "senses: {hot: True}}\n";
  const std::string scenario = folder.Write("s.yaml", yaml);
  for (const std::string& file : ExampleFiles()) {
    INFO(file);
    const std::string text = ReadFile(file);
    if (!HasBodies(text)) continue;
    for (const char* engine : {"ode", "articulated"}) {
      const std::string recording = folder / "life.json";
      const Ran lived =
          RunPlsc({"simulate", file, "--scenario", scenario, "--engine", engine,
                   "--format", "json", "--record", recording, "--force"});
      INFO(lived.err);
      REQUIRE(lived.exit == 0);
      const std::string answer = AnswerTo({{"ask", "live"},
                                           {"text", text},
                                           {"scenario", yaml},
                                           {"engine", engine},
                                           {"record", true}});
      CheckHolds(answer, "\"seasons\":[" + Listed(lived.out) + "]");
      std::string recorded = ReadFile(recording);
      std::erase(recorded, '\n');
      CheckHolds(answer,
                 "\"recording\":" + recorded.substr(0, recorded.size() - 1));
    }
  }
}

TEST_CASE("the service draws and compares as the commands do",
          "[cli][service]") {
  const TemporaryFolder folder;
  const std::vector<std::string> files = ExampleFiles();
  for (const std::string& file : files) {
    const std::string text = ReadFile(file);
    if (!HasBodies(text)) continue;
    INFO(file);
    const Asked answer =
        Asked::parse(AnswerTo({{"ask", "picture"}, {"text", text}}));
    const std::string svg = folder / "a.svg";
    for (const auto& [key, options] :
         std::vector<std::pair<std::string, std::vector<std::string>>>{
             {"body", {}},
             {"rules", {"--colour", "rule"}},
             {"brain", {"--brain"}}}) {
      std::vector<std::string> arguments{"draw", file, "-o", svg, "--force"};
      arguments.insert(arguments.end(), options.begin(), options.end());
      const Ran drawn = RunPlsc(arguments);
      INFO(drawn.err);
      REQUIRE(drawn.exit == 0);
      CHECK(ReadFile(svg) == answer[key].get<std::string>());
    }
    const Ran compared =
        RunPlsc({"diff", "--format", "json", files.front(), file});
    CHECK(AnswerTo({{"ask", "compare"},
                    {"before", ReadFile(files.front())},
                    {"text", text}}) ==
          R"({"id":null,"ask":"compare","ok":true,"difference":)" +
              compared.out.substr(0, compared.out.size() - 1) + "}");
  }
}

}  // namespace
}  // namespace plsc::test
