#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc::test {
namespace {

std::string Replaced(std::string text, const std::string& from,
                     const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

Ran Diff(const std::string& before, const std::string& after,
         std::vector<std::string> options = {}) {
  const TemporaryFolder folder;
  std::vector<std::string> arguments{"diff", folder.Write("old.pls", before),
                                     folder.Write("new.pls", after)};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return RunPlsc(arguments);
}

TEST_CASE("diff answers 0 where no robot differs", "[cli][diff]") {
  const std::string text = kPlasticText;
  const Ran same = Diff(text, "# new\n" + text);
  CHECK(same.exit == 0);
  CHECK(same.out ==
        "plastic in flat (inclined=False); tilted (inclined=True): the same\n");
  // A rule of a symbol that never occurs.
  const Ran unused = Diff(text, text + "rule A1 -> { add_left }\n");
  CHECK(unused.exit == 0);
  CHECK(unused.out.find("+ rule 1 of A1 (line 12)\n    + rule A1 ->\n") == 0);
  CHECK(unused.out.ends_with(": the same\n"));
}

TEST_CASE("diff answers 1 and says what differs where", "[cli][diff]") {
  const Ran ran =
      Diff(kPlasticText, Replaced(kPlasticText, "A2(0.5, 2.0", "A2(0.5, 2.5"));
  CHECK(ran.exit == 1);
  CHECK(ran.out ==
        "~ rule 2 of C (line 7)\n"
        "      C\n      add_left\n    ~ A2(0.5, 2 -> 2.5, 3, 1)\n"
        "      move_left\n      add_front\n      ...\n"
        "plastic in flat (inclined=False): the same\n"
        "plastic in tilted (inclined=True):\n"
        "    ~ amplitude of node1 (A2 at x=-1,y=0): 2 -> 2.5\n");
}

TEST_CASE("diff looks at chosen environments only", "[cli][diff]") {
  const std::string changed =
      Replaced(kPlasticText, "A2(0.5, 2.0", "A2(0.5, 2.5");
  CHECK(Diff(kPlasticText, changed, {"--env", "flat"}).exit == 0);
  CHECK(Diff(kPlasticText, changed, {"--env", "inclined=True"}).exit == 1);
  CHECK(Diff(kPlasticText, changed, {"--env", "steep"}).exit == 2);
}

TEST_CASE("diff paints what it is told to", "[cli][diff]") {
  const Ran ran =
      Diff(kPlasticText, Replaced(kPlasticText, "add_front B }", "B }"),
           {"--color", "always"});
  CHECK(ran.out.find("\x1b[31m- add_front\x1b[0m") != std::string::npos);
  CHECK(Diff(kPlasticText, kPlasticText).out.find('\x1b') == std::string::npos);
}

TEST_CASE("diff compares genotypes of files by their names", "[cli][diff]") {
  const std::string head = "plsc 1\nalphabet plasticoding 1\n";
  const std::string a = "genotype a\nrule C -> { C add_left B }\n";
  const std::string b = "genotype b\nrule C -> { C add_right B }\n";
  CHECK(Diff(head + a + b, head + b + a).exit == 0);
  const Ran ran = Diff(head + a + b, head + a + "genotype c\n");
  CHECK(ran.exit == 1);
  CHECK(ran.out.find("c: a new genotype\n") != std::string::npos);
  CHECK(ran.out.find("b: the genotype is gone\n") != std::string::npos);
  CHECK(ran.out.find("a in any: the same\n") != std::string::npos);
  const TemporaryFolder folder;
  const std::string zoo = folder.Write("zoo.pls", head + a + b);
  const Ran two = RunPlsc({"diff", zoo + "#a", zoo + "#b"});
  CHECK(two.exit == 1);
  CHECK(two.out.find("add_left -> add_right") != std::string::npos);
  CHECK(RunPlsc({"diff", zoo + "#a", zoo + "#x"}).exit == 2);
}

TEST_CASE("diff prints JSON", "[cli][diff]") {
  const Ran ran =
      Diff(kPlasticText, Replaced(kPlasticText, "A2(0.5, 2.0", "A2(0.5, 2.5"),
           {"--format", "json"});
  const auto json = nlohmann::json::parse(ran.out);
  CHECK(json["differs"] == true);
  CHECK(json["texts"][0]["changes"][0]["item"] == "rule 2 of C");
  CHECK(json["robots"][0]["environments"].size() == 2);
}

TEST_CASE("diff answers 2 to what it cannot compare", "[cli][diff]") {
  const std::vector<std::string> wrong{"", "plsc 1\n", "\xff",
                                       std::string(kPlasticText, 60)};
  for (const std::string& text : wrong) {
    CHECK(Diff(text, kPlasticText).exit == 2);
    const Ran ran = Diff(kPlasticText, text);
    CHECK(ran.exit == 2);
    CHECK(ran.err.find("error[P") != std::string::npos);
    CHECK(ran.out.empty());
  }
  CHECK(RunPlsc({"diff", "none.pls", "/"}).exit == 2);
  CHECK(RunPlsc({"diff", "one.pls"}).exit == 2);
  CHECK(RunPlsc({"diff", "a", "b", "c"}).exit == 2);
  CHECK(RunPlsc({"diff", "--git", "a", "b", "c"}).exit == 2);
}

TEST_CASE("diff answers git as it wants it", "[cli][diff]") {
  const TemporaryFolder folder;
  const std::string file = folder.Write("x.pls", kPlasticText);
  const std::string broken = folder.Write("y.pls", "plsc 1\nrule\n");
  const auto git = [](const std::string& before, const std::string& after) {
    return RunPlsc(
        {"diff", "--git", "p.pls", before, "00", "100644", after, "00", "0"});
  };
  CHECK(git("/dev/null", file).out ==
        "plsc diff a/p.pls b/p.pls\nplastic: a new genotype\n");
  CHECK(git(file, "/dev/null").out ==
        "plsc diff a/p.pls b/p.pls\nplastic: the genotype is gone\n");
  const Ran by_lines = git(file, broken);
  CHECK(by_lines.exit == 0);
  CHECK(by_lines.out.find("+rule\n") != std::string::npos);
  CHECK(RunPlsc({"diff", "--git", "p.pls"}).out == "* Unmerged path p.pls\n");
}

}  // namespace
}  // namespace plsc::test
