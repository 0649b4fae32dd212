#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;
using test::RunPlsc;

bool Shows(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_CASE("test records, compares and shows what changed", "[test]") {
  const test::TemporaryFolder folder;
  std::string text = test::kPlasticText;
  const std::string path = folder.Write("plastic.pls", text);
  const std::string golden = folder / "plastic.golden.json";

  const auto missing = RunPlsc({"test", path});
  CHECK(missing.exit == 1);
  CHECK(Shows(missing.out, "there is no golden file '" + golden + "'"));
  CHECK(folder.Files().size() == 1);

  const auto created = RunPlsc({"test", path, "--update"});
  CHECK(created.exit == 0);
  CHECK(Shows(created.out, path + " in tilted: updated " + golden));
  CHECK(folder.Files() ==
        std::vector<std::string>{"plastic.golden.json", "plastic.pls"});

  for (const std::string& named : {path, golden, folder.path().string()}) {
    const auto same = RunPlsc({"test", named});
    CHECK(same.exit == 0);
    CHECK(same.out == "2 tests of 1 file: 2 as expected\n");
  }

  text.replace(text.find("add_front B }"), 13, "add_left B } ");
  folder.Write("plastic.pls", text);
  const auto differs = RunPlsc({"test", path});
  CHECK(differs.exit == 1);
  CHECK(Shows(differs.out,
              path + " in flat differs from " + golden +
                  ":\n"
                  "  string at symbol 2: expected add_front, found add_left\n"
                  "  module 2 (B) moved: expected x=0,y=1, found x=-1,y=0\n"));
  CHECK(!Shows(differs.out, "in tilted"));

  CHECK(RunPlsc({"test", path, "--update"}).exit == 0);
  CHECK(RunPlsc({"test", path}).exit == 0);
}

TEST_CASE("test runs the tests that a file states itself", "[test]") {
  const test::TemporaryFolder folder;
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\niterations 1\n"
      "rule C -> { C add_left B }\n"
      "test right -> body C { left B }\n";
  const std::string path = folder.Write("a.pls", text);
  CHECK(RunPlsc({"test", path}).out == "1 test of 1 file: 1 as expected\n");
  folder.Write("a.pls", text + "test wrong -> { C add_left T }\n");
  const auto differs = RunPlsc({"test", path});
  CHECK(differs.exit == 1);
  CHECK(Shows(differs.out, "error[P4002]: test 'wrong' fails\n"));
  CHECK(Shows(differs.out, "a.pls:6:28\n"));
  CHECK(Shows(differs.out, "2 tests of 1 file: 1 as expected, 1 differs\n"));
  // Only a person can say what was meant.
  CHECK(!Shows(differs.out, "--update"));
  const auto json = RunPlsc({"test", "--format", "json", path});
  CHECK(
      Shows(json.out, R"("genotype":null,"test":"wrong","environment":null)"));
  const auto junit = RunPlsc({"test", "--format", "junit", path});
  CHECK(Shows(junit.out, "name=\"test wrong\">"));
  // Beside a golden file both count.
  CHECK(RunPlsc({"test", "--update", path}).exit == 1);
  CHECK(Shows(RunPlsc({"test", path}).out, "3 tests of 1 file"));
}

TEST_CASE("test knows the genotypes of a file apart", "[test]") {
  const test::TemporaryFolder folder;
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\niterations 1\n"
      "genotype a\nrule C -> { C add_left B }\n"
      "genotype b\nrule C -> { C add_right B }\n"
      "test body -> body C { right B }\n";
  const std::string path = folder.Write("zoo.pls", text);
  CHECK(RunPlsc({"test", "--update", path}).exit == 0);
  CHECK(RunPlsc({"test", path}).out == "3 tests of 1 file: 3 as expected\n");
  std::string changed = text;
  changed.replace(changed.find("add_left"), 8, "add_front");
  folder.Write("zoo.pls", changed);
  const auto differs = RunPlsc({"test", path});
  CHECK(differs.exit == 1);
  CHECK(Shows(differs.out, "zoo.pls#a in any differs from "));
  CHECK(!Shows(differs.out, "zoo.pls#b in any"));
  // A golden file from before a genotype was renamed.
  std::string renamed = text;
  renamed.replace(renamed.find("genotype a"), 10, "genotype c");
  folder.Write("zoo.pls", renamed);
  CHECK(Shows(RunPlsc({"test", path}).out,
              "error: the genotype's file has no genotype 'a'\n"));
}

TEST_CASE("test --update leaves alone what is as expected", "[test]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("plastic.pls", test::kPlasticText);
  const std::string golden = folder / "plastic.golden.json";
  CHECK(RunPlsc({"test", path, "--update"}).exit == 0);
  // Another layout of the same facts is not rewritten.
  folder.Write("plastic.golden.json", test::ReadFile(golden) + "\n\n");
  const std::string before = test::ReadFile(golden);
  const auto again = RunPlsc({"test", path, "--update"});
  CHECK(again.exit == 0);
  CHECK(!Shows(again.out, "updated"));
  CHECK(test::ReadFile(golden) == before);
}

TEST_CASE("test --update does not touch what it cannot read", "[test]") {
  const test::TemporaryFolder folder;
  folder.Write("a.pls", test::kPlasticText);
  folder.Write("b.pls", test::kPlasticText);
  folder.Write("a.golden.json", "{\"plsc_golden\": 1, ");
  const auto ran = RunPlsc({"test", folder.path().string(), "--update"});
  CHECK(ran.exit == 1);
  CHECK(Shows(ran.out, "a.golden.json:1:20"));
  CHECK(Shows(ran.out, "b.pls in flat: updated"));
  CHECK(test::ReadFile(folder / "a.golden.json") == "{\"plsc_golden\": 1, ");
}

TEST_CASE("test --update says when a golden file cannot be written", "[test]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("plastic.pls", test::kPlasticText);
  // A folder of that name stops everybody, permissions not even root.
  fs::create_directory(folder / "plastic.golden.json");
  const auto taken = RunPlsc({"test", path, "--update"});
  CHECK(taken.exit == 1);
  CHECK(Shows(taken.out, "plastic.golden.json"));
  CHECK(fs::is_directory(folder / "plastic.golden.json"));
  if (::geteuid() == 0) return;
  fs::remove(folder / "plastic.golden.json");
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  const auto readonly = RunPlsc({"test", path, "--update"});
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(readonly.exit == 1);
  CHECK(Shows(readonly.out, "cannot write"));
}

TEST_CASE("test gives the same bytes for any number of jobs", "[test]") {
  const test::TemporaryFolder folder;
  for (int i = 0; i < 40; ++i)
    folder.Write("robot" + std::to_string(i) + ".pls", test::kPlasticText);
  REQUIRE(RunPlsc({"test", folder.path().string(), "--update", "--jobs", "3"})
              .exit == 0);
  std::string text = test::kPlasticText;
  text.replace(text.find("0.5, 2.0"), 8, "0.5, 2.5");
  for (int i = 0; i < 40; i += 3)
    folder.Write("robot" + std::to_string(i) + ".pls", text);
  folder.Write("robot7.pls", "plsc 1\nnonsense\n");
  for (const char* format : {"text", "json", "junit"}) {
    const auto one = RunPlsc(
        {"test", folder.path().string(), "--format", format, "--jobs", "1"});
    CHECK(one.exit == 1);
    for (const char* jobs : {"2", "5", "64"})
      CHECK(RunPlsc({"test", folder.path().string(), "--format", format,
                     "--jobs", jobs})
                .out == one.out);
  }
}

TEST_CASE("test --output has the report, standard output the text", "[test]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("plastic.pls", test::kPlasticText);
  for (const char* format : {"text", "json", "junit"}) {
    INFO(format);
    const auto direct = RunPlsc({"test", path, "--format", format});
    const auto text = RunPlsc({"test", path});
    const auto ran = RunPlsc(
        {"test", path, "--format", format, "--output", folder / format});
    CHECK(ran.exit == 1);
    CHECK(ran.out == text.out);
    CHECK(test::ReadFile(folder / format) == direct.out);
  }
  const auto failed =
      RunPlsc({"test", path, "--output", folder / "none/report"});
  CHECK(failed.exit == 1);
  CHECK(Shows(failed.err, "cannot write"));
}

TEST_CASE("test explains what it cannot test", "[test]") {
  const test::TemporaryFolder folder;
  folder.Write("lonely.golden.json", "{}");
  struct Row {
    const char* why;
    std::vector<std::string> paths;
    int exit;
    const char* message;
  };
  const std::vector<Row> rows = {
      {"no path", {}, 2, "PATH"},
      {"standard input", {"-"}, 2, "standard input has no golden file"},
      {"no such file", {folder / "none.pls"}, 1, "cannot read"},
      {"no genotype",
       {folder / "lonely.golden.json"},
       1,
       "there is no genotype"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      std::vector<std::string> arguments{"test"};
      arguments.insert(arguments.end(), row.paths.begin(), row.paths.end());
      const auto ran = RunPlsc(arguments);
      CHECK(ran.exit == row.exit);
      CHECK(Shows(ran.out + ran.err, row.message));
    }
  }
}

}  // namespace
}  // namespace plsc
