#include "runtime/cli/files/file_kind.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace plsc::cli {
namespace {

TEST_CASE("A text tells its kind", "[check]") {
  struct Row {
    std::string text;
    FileKind kind;
  };
  const std::vector<Row> rows = {
      {"plsc 1\ngenotype a\n", FileKind::kGenotype},
      {"", FileKind::kGenotype},
      {"# only a comment\n", FileKind::kGenotype},
      {"rule C -> { C }\nexperiments: 3\n", FileKind::kGenotype},
      {"{<Alphabet.CORE_COMPONENT: 'C'>: [[]]}", FileKind::kGenotype},
      {"plsc_experiment: 1\n", FileKind::kExperiment},
      {"\xEF\xBB\xBF# c\n\n---\nplsc_scenario: 1\n", FileKind::kScenario},
      {"plsc_study: 1\r\nseed: 2\r\n", FileKind::kStudy},
      {"name: a\nseasons:\n  - {terrain: flat}\n", FileKind::kScenario},
      {"name: a\nexperiments:\n  a: {}\n", FileKind::kStudy},
      {"population: 5\nscenario:\n  seasons: []\n", FileKind::kExperiment},
      {"\"plsc_experiment\": 1\n", FileKind::kExperiment},
      {"{plsc_scenario: 1, seasons: []}", FileKind::kScenario},
      {"{\n\"plsc_golden\": 1}", FileKind::kGolden},
      {"{\"plsc_recording\":1}", FileKind::kRecording},
      {std::string("SQLite format 3\0", 16), FileKind::kStore},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text);
    CHECK(KindOf(row.text) == row.kind);
  }
}

}  // namespace
}  // namespace plsc::cli
