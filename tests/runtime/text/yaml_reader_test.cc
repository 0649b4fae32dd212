#include "runtime/text/yaml_reader.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace plsc {

namespace {

enum class Colour : std::uint8_t { kRed, kGreen };
constexpr EnumNames<Colour, 2> kColourNames{
    {{Colour::kRed, "red"}, {Colour::kGreen, "green"}}};

/// Reads a few keys of each kind, and reports what it found wrong.
std::string Errors(const std::string& text) {
  const Source source("test.yaml", text);
  const YamlFile file(source);
  if (auto root = file.Root("a test")) {
    root->Number("duration", 1, {Dimension::kTime, 0, 60});
    root->Int("count", 1, 0, 100);
    root->Bool("growing", false);
    root->Text("name", "x");
    root->Choice("colour", Colour::kRed, kColourNames);
    if (const auto seed = root->Find("seed")) seed->Unsigned();
    if (const auto list = root->Find("items")) {
      const auto items = list->List("numbers");
      if (items)
        for (const YamlValue& item : *items) item.Number({Dimension::kNumber});
    }
    root->Close();
  }
  return Render(file.diagnostics(), source, 0);
}

}  // namespace

TEST_CASE("A file that is all right gives its values", "[yaml]") {
  const Source source("test.yaml",
                      "duration: 50 s\ncount: 7\ngrowing: True\n"
                      "name: 'a b'\ncolour: green\n"
                      "seed: 18446744073709551615\n");
  const YamlFile file(source);
  auto root = file.Root("a test");
  REQUIRE(root);
  CHECK(root->Number("duration", 1, {Dimension::kTime}) == 50);
  CHECK(root->Int("count", 1, 0, 100) == 7);
  CHECK(root->Bool("growing", false));
  CHECK(root->Text("name", "") == "a b");
  CHECK(root->Choice("colour", Colour::kRed, kColourNames) == Colour::kGreen);
  CHECK(root->Find("seed")->Unsigned() == 18446744073709551615u);
  CHECK(root->Int("missing", 42, 0, 100) == 42);
  root->Close();
  CHECK(file.diagnostics().empty());
}

TEST_CASE("Every mistake is shown where it is", "[yaml]") {
  struct Row {
    const char* why;
    const char* text;
    std::vector<const char*> parts;  ///< of the rendered errors
  };
  const std::vector<Row> rows = {
      {"an unknown key, with the nearest known one",
       "name: a\ndurration: 5\n",
       {"error[P5101]: unknown key 'durration'", "test.yaml:2:1",
        "2 | durration: 5", "^^^^^^^^^", "did you mean 'duration'?"}},
      {"an unknown key far from all: the known ones",
       "zzz: 5\n",
       {"unknown key 'zzz'", "known here: duration, count, growing"}},
      {"a key given twice",
       "name: a\ncount: 1\ncount: 2\n",
       {"error[P5102]: 'count' is given twice", "test.yaml:3:1"}},
      {"a word for a number",
       "duration: long\n",
       {"error[P5103]: expected a time, found 'long'", "test.yaml:1:11", "^^^^",
        "write it as in '1 s'"}},
      {"a wrong unit",
       "duration: 50 m\n",
       {"error[P5105]: expected a time in s, ms or min, found 'm'", "^^^^"}},
      {"out of range",
       "duration: 100 s\n",
       {"error[P5104]: expected at least 0 s and at most 60 s, found 100 s"}},
      {"a number in quotes",
       "duration: '50'\n",
       {"expected a time, found a text in quotes", "write '50', without quotes",
        "^^^^"}},
      {"a map for a number",
       "duration: {a: 1}\n",
       {"expected a time, found a map"}},
      {"nothing for a number",
       "duration:\nname: a\n",
       {"expected a time, found nothing"}},
      {"a fraction for a count",
       "count: 1.5\n",
       {"error[P5103]: expected a whole number, found '1.5'"}},
      {"a count out of range",
       "count: 101\n",
       {"error[P5104]: expected a whole number of 0 to 100, found 101"}},
      {"a count beyond 64 bits",
       "count: 99999999999999999999\n",
       {"expected a whole number of 0 to 100"}},
      {"a negative seed",
       "seed: -1\n",
       {"expected a whole number of 0 to 18446744073709551615, found '-1'"}},
      {"YAML's other words for true",
       "growing: yes\n",
       {"expected True or False, found 'yes'"}},
      {"an unknown word",
       "colour: gren\n",
       {"error[P5107]: expected red or green, found 'gren'",
        "did you mean 'green'?"}},
      {"an empty text", "name: ''\n", {"expected a name, found an empty text"}},
      {"a list that is none",
       "items: 5\n",
       {"expected a list of numbers, found '5'"}},
      {"an item of a list",
       "items: [1, two, 3]\n",
       {"expected a number, found 'two'", "test.yaml:1:12"}},
      {"several at once",
       "duration: x\ncount: y\nnonsense: 1\n",
       {"found 'x'", "found 'y'", "unknown key 'nonsense'"}},
      {"a list instead of a map", "- a\n", {"expected a test, found a list"}},
      {"an empty file", "", {"expected one YAML document, found 0"}},
      {"two documents",
       "name: a\n---\nname: b\n",
       {"expected one YAML document, found 2", "test.yaml:2:1"}},
      // Found by scenario_fuzz: yaml-cpp reads documents without end.
      {"a comma outside of brackets",
       "- a\n, b\n",
       {"error[P5100]: this is not YAML: a ',' outside of all brackets",
        "test.yaml:2:1"}},
      {"a comma alone",
       ",\n",
       {"error[P5100]: this is not YAML: a ','", "test.yaml:1:1"}},
      {"no YAML at all",
       "name: [a\ncount: 5\n",
       {"error[P5100]: this is not YAML"}},
      {"merge keys are not understood",
       "a: &b {name: c}\n<<: *b\n",
       {"unknown key '<<'"}},
      {"after characters of several bytes",
       "name: [\"\xC3\xA4\xC3\xB6\", b]\nqqq: \xC3\xA4\n",
       {"expected a name, found a list", "test.yaml:2:1"}},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const std::string errors = Errors(row.text);
      for (const char* part : row.parts) {
        INFO(errors);
        CHECK(errors.find(part) != std::string::npos);
      }
    }
  }
}

TEST_CASE("What is no UTF-8 text is refused", "[yaml]") {
  CHECK(Errors(std::string("name: a\0b\n", 10)).find("byte 0x00 at offset 7") !=
        std::string::npos);
  CHECK(Errors("name: \xFF\n").find("byte 0xFF at offset 6") !=
        std::string::npos);
  CHECK(Errors("  \n").find("found 0") != std::string::npos);
}

TEST_CASE("A byte order mark moves no place", "[yaml]") {
  const std::string errors = Errors("\xEF\xBB\xBFqqq: 1\nzzz: 1\n");
  INFO(errors);
  // The mark counts as a character.
  CHECK(errors.find("test.yaml:1:2\n") != std::string::npos);
  CHECK(errors.find("test.yaml:2:1\n") != std::string::npos);
}

// Not timed, but the time must not grow with the square of the keys.
TEST_CASE("A map of very many keys is read", "[yaml]") {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += "k" + std::to_string(i) + ": 1\n";
  const Source source("test.yaml", text + "k0: 2\n");
  const YamlFile file(source);
  auto root = file.Root("a test");
  REQUIRE(root);
  CHECK(root->TakeAll().size() == 50000);
  root->Close();
  REQUIRE(file.diagnostics().size() == 1);
  CHECK(file.diagnostics()[0].code == Code::kRepeatedKey);
}

TEST_CASE("Errors are collected up to a limit", "[yaml]") {
  std::string text;
  for (std::size_t i = 0; i < 2 * kMaxReported; ++i)
    text += "k" + std::to_string(i) + ": 1\n";
  const Source source("test.yaml", text);
  const YamlFile file(source);
  auto root = file.Root("a test");
  REQUIRE(root);
  CHECK_FALSE(root->place().is_full());
  root->Close();
  CHECK(root->place().is_full());
  CHECK(file.diagnostics().size() == kMaxReported);
}

TEST_CASE("Values are counted, aliases as often as they stand", "[yaml]") {
  std::string text = "a0: &a0 [x, x]\n";
  for (int i = 1; i <= 40; ++i) {
    const std::string one = std::to_string(i);
    const std::string before = "*a" + std::to_string(i - 1);
    text += "a" + one + ": &a" + one + " [" + before + ", " + before + "]\n";
  }
  const Source source("test.yaml", text);
  const YamlFile file(source);
  auto root = file.Root("a test");
  REQUIRE(root);
  CHECK(root->Find("a0")->CountValues(1000) == 3);
  CHECK(root->Find("a0")->CountEntries() == 2);
  CHECK(root->Find("a2")->CountValues(1000) == 15);
  CHECK(root->Find("a40")->CountValues(1000) == 1000);
}

}  // namespace plsc
