#include <catch2/catch.hpp>
#include <filesystem>

#include "compiler/compile.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

const std::string kExport =
    "{<Alphabet.CORE_COMPONENT: 'C'>: [[[['hill', '==', True]], "
    "[[<Alphabet.CORE_COMPONENT: 'C'>, []], [<Alphabet.ADD_LEFT: 'addl'>, "
    "[]], [<Alphabet.JOINT_VERTICAL: 'AJ2'>, [0.5, 2.0, 3.0, 4.0]]]]]}";

TEST_CASE("import prints a genotype of plsc", "[cli][import]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("genotype_robot-12.txt", kExport);
  const auto ran = RunPlsc({"import", file, "--rename", "hill=inclined"});
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  CHECK(ran.out ==
        "plsc 1\n\ngenotype genotype_robot_12\nalphabet plasticoding 1\n"
        "sense inclined: bool\naxiom C\niterations 3\nmax_modules 15\n"
        "move_to_new False\nmax_terms 2\nmax_rules 2\n\nrule C -> if inclined "
        "= True then {\n  C\n"
        "  add_left\n  A1(0.5, 4, 2, 3)\n}\n\n"
        "environment plane { inclined = False }\n"
        "environment tilted5 { inclined = True }\n");
  CHECK(Compile(Source("imported", ran.out)));
}

TEST_CASE("import reads both forms, and can be told which", "[cli][import]") {
  const std::string lines = "C C addl ST_0.5 \n";
  CHECK(RunPlsc({"import", "-"}, lines).exit == 0);
  CHECK(RunPlsc({"import", "-", "--format", "lines"}, lines).exit == 0);
  CHECK(RunPlsc({"import", "-", "--format", "repr"}, lines).exit == 1);
  CHECK(RunPlsc({"import", "-", "--format", "lines"}, kExport).exit == 1);
  const auto named = RunPlsc({"import", "-", "--name", "old"}, lines);
  CHECK(named.out.find("genotype old\n") != std::string::npos);
}

TEST_CASE("import names place, line and mend of what is wrong",
          "[cli][import]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.Write("bad.txt", "C C adll ST_0.5 \n");
  const std::string out = folder / "out.pls";
  const auto ran = RunPlsc({"import", file, "-o", out});
  CHECK(ran.exit == 1);
  CHECK(ran.out.empty());
  CHECK(ran.err.find("error[P2001]") != std::string::npos);
  CHECK(ran.err.find(file + ":1:5") != std::string::npos);
  CHECK(ran.err.find("did you mean 'addl'?") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("import of what is out of range wants to be told", "[cli][import]") {
  const std::string text = "B addl ST_2 \n";
  CHECK(RunPlsc({"import", "-"}, text).exit == 1);
  const auto ran = RunPlsc({"import", "-", "--allow-range"}, text);
  CHECK(ran.exit == 0);
  CHECK(RunPlsc({"check", "-"}, ran.out).exit == 1);
  CHECK(RunPlsc({"check", "-", "--allow-range"}, ran.out).exit == 0);
}

TEST_CASE("import of anything else changes nothing", "[cli][import]") {
  const test::TemporaryFolder folder;
  CHECK(RunPlsc({"import", "-"}, "").exit == 1);
  CHECK(RunPlsc({"import", "-"}, test::kPlasticText).exit == 1);
  CHECK(RunPlsc({"import", "-"}, std::string("{\0", 2)).exit == 1);
  CHECK(RunPlsc({"import", "-"}, kExport.substr(0, 99)).exit == 1);
  CHECK(RunPlsc({"import", folder / "none.txt"}).exit == 1);
  CHECK(RunPlsc({"import", folder.path().string()}).exit == 1);
  CHECK(RunPlsc({"import", "-", "--rename", "x=y"}, kExport).exit == 2);
  CHECK(RunPlsc({"import", "-", "--rename", "hill=if"}, kExport).exit == 2);
  CHECK(RunPlsc({"import", "-", "--rename", "hill"}, kExport).exit == 2);
  CHECK(RunPlsc({"import", "-", "--name", "a b"}, kExport).exit == 2);
  const std::string file = folder.Write("a.txt", kExport);
  CHECK(RunPlsc({"import", file, "-o", file}).exit == 1);
  CHECK(test::ReadFile(file) == kExport);
  CHECK(folder.Files() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("check of Revolve's files speaks of import", "[cli][import]") {
  const auto ran = RunPlsc({"check", "-"}, kExport);
  CHECK(ran.exit == 1);
  CHECK(ran.err.find("plsc import") != std::string::npos);
}

TEST_CASE("import and check know such a file behind a byte order mark",
          "[cli][import]") {
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string& text : {kExport, std::string("C C addl ST_0.5 \n")}) {
    const auto ran = RunPlsc({"import", "-"}, mark + text);
    CHECK(ran.exit == 0);
    CHECK(ran.out == RunPlsc({"import", "-"}, text).out);
    CHECK(RunPlsc({"check", "-"}, mark + text).err.find("error[P5012]") !=
          std::string::npos);
  }
}

}  // namespace
}  // namespace plsc
