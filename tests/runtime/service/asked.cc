#include "tests/runtime/service/asked.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/service/service.h"

namespace plsc::test {

namespace {

std::string FileText(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::filesystem::path ExamplesFolder() {
  return std::filesystem::path(PLSC_SOURCE_DIR) / "examples";
}

}  // namespace

std::string AnsweredText(const OrderedJson& request) {
  const std::string text = request.dump();
  Service service("1.2.3");
  const std::string answer = service.Answer(text);
  REQUIRE(nlohmann::json::accept(answer));
  REQUIRE(answer.find('\n') == std::string::npos);
  REQUIRE(service.Answer(text) == answer);
  return answer;
}

OrderedJson Answered(const OrderedJson& request) {
  return OrderedJson::parse(AnsweredText(request));
}

bool HoldsBytes(const std::string& answer, const std::string& part) {
  return answer.find(part) != std::string::npos;
}

std::string WordsOf(const OrderedJson& request) {
  const OrderedJson answer = Answered(request);
  INFO(answer.dump().substr(0, 500));
  REQUIRE(answer["ok"] == false);
  REQUIRE(answer["error"].is_string());
  return answer["error"];
}

std::vector<std::pair<std::string, std::string>> ExampleTexts() {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(ExamplesFolder()))
    if (entry.path().extension() == ".pls")
      texts.emplace_back(entry.path().filename().string(),
                         FileText(entry.path()));
  std::sort(texts.begin(), texts.end());
  REQUIRE(texts.size() >= 6);
  return texts;
}

std::string ExampleText(const std::string& name) {
  return FileText(ExamplesFolder() / name);
}

std::string ShortScenario() {
  return "plsc_scenario: 1\nseasons:\n"
         "  - name: level\n    terrain: flat\n    duration: 0.5 s\n"
         "    senses: {hot: False, inclined: False}\n"
         "  - name: hill\n    terrain: {tilted: 5 deg}\n    duration: 0.5 s\n"
         "    senses: {hot: False, inclined: True}\n";
}

}  // namespace plsc::test
