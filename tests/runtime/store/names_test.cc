#include "runtime/store/names.h"

#include <catch2/catch.hpp>
#include <limits>

namespace plsc {

TEST_CASE("Keys come back from their digits", "[names]") {
  const Key key{0x00ff00ff12345678, std::numeric_limits<std::uint64_t>::max()};
  CHECK(KeyOfHex(Hex(key)) == key);
  for (const char* wrong :
       {"", "00ff", "00ff00ff12345678ffffffffffffffffa",
        "00ff00ff1234567gffffffffffffffff", "-0ff00ff12345678ffffffffffffffff"})
    CHECK_FALSE(KeyOfHex(wrong));
}

TEST_CASE("What was sensed comes back in its order", "[names]") {
  const std::vector<SensedState> sensed = {
      {"wet", "True", SenseSource::kSeason},
      {"inclined", "False", SenseSource::kImu},
      {"ground", "\"sand\"\n\xc3\xa9", SenseSource::kParent}};
  CHECK(SensedOf(SensedText(sensed), SourcesText(sensed)) == sensed);
  CHECK(SensedText({}) == "{}");
  CHECK(SensedOf("{}", "{}") == std::vector<SensedState>{});
  struct Row {
    const char* why;
    const char* sensed;
    const char* sources;
  };
  const std::vector<Row> rows = {
      {"no JSON", "{", "{}"},
      {"no object", "[]", "{}"},
      {"no source", R"({"a":"True"})", "{}"},
      {"unknown source", R"({"a":"True"})", R"({"a":"god"})"},
      {"no text", R"({"a":1})", R"({"a":"imu"})"},
      {"no text as source", R"({"a":"1"})", R"({"a":2})"}};
  for (const Row& row : rows) {
    CAPTURE(row.why);
    CHECK_FALSE(SensedOf(row.sensed, row.sources));
  }
}

TEST_CASE("Heads and senses come back", "[names]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  const std::vector<SymbolId> heads = {plasticoding::kA1, plasticoding::kT};
  CHECK(HeadsText(heads, alphabet) == R"(["A1","T"])");
  CHECK(HeadsOf(HeadsText(heads, alphabet), alphabet) == heads);
  for (const char* wrong : {"[\"Q\"]", "[1]", "{}", "", "[\"A1\""})
    CHECK_FALSE(HeadsOf(wrong, alphabet));
  const std::map<std::string, std::string> senses = {{"a", "True"},
                                                     {"b", "1.5"}};
  CHECK(SensesOf(SensesText(senses)) == senses);
  for (const char* wrong : {"[]", "{\"a\":1}", "", "{\"a\":"})
    CHECK_FALSE(SensesOf(wrong));
  // No UTF-8, which JSON has no way to write.
  CHECK_FALSE(SensesText({{"a", "\xff"}}).empty());
}

}  // namespace plsc
