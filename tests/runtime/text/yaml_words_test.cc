#include "runtime/text/yaml_words.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("Whole numbers are known in other spellings", "[yaml]") {
  struct Row {
    const char* text;
    std::optional<std::int64_t> meant;
  };
  const std::vector<Row> rows = {
      {"1e3", 1000},           {"100.0", 100},
      {"1,000", 1000},         {"1_000_000", 1000000},
      {"5 robots", 5},         {"-3", -3},
      {"80%", std::nullopt},   {"80 percent", std::nullopt},
      {"0,8", std::nullopt},   {"2.5", std::nullopt},
      {"", std::nullopt},      {"many", std::nullopt},
      {"1e300", std::nullopt}, {"nan", std::nullopt}};
  for (const Row& row : rows) {
    CAPTURE(row.text);
    CHECK(WholeNumberMeant(row.text) == row.meant);
  }
}

TEST_CASE("Truth values are known in other spellings", "[yaml]") {
  for (const char* text : {"yes", "On", "TRUE", "1", "Ture", "y"})
    CHECK(TruthMeant(text) == "True");
  for (const char* text : {"no", "OFF", "false", "0", "Flase", "n"})
    CHECK(TruthMeant(text) == "False");
  CHECK(TruthMeant("maybe").empty());
}

TEST_CASE("Words of YAML are known in any case", "[yaml]") {
  for (const char* word : {"null", "NULL", "yes", "No", "on", "Y", "tRUE"})
    CHECK(IsYamlWord(word));
  for (const char* word : {"none", "nothing", "plastic", "ya"})
    CHECK_FALSE(IsYamlWord(word));
}

}  // namespace
}  // namespace plsc
