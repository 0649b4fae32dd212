#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

using test::RunPlsc;

TEST_CASE("hash ignores how a genotype is written", "[cli][hash]") {
  const test::TemporaryFolder folder;
  const std::string a = folder.Write("a.pls", test::kPlasticText);
  const std::string b = folder.Write("b.pls", test::kPlasticText);
  CHECK(RunPlsc({"fmt", b}).exit == 0);
  CHECK(test::ReadFile(a) != test::ReadFile(b));
  const auto ran = RunPlsc({"hash", a, b});
  CHECK(ran.exit == 0);
  const std::string digits = ran.out.substr(0, 32);
  CHECK(digits.find_first_not_of("0123456789abcdef") == std::string::npos);
  CHECK(ran.out == digits + "  " + a + "\n" + digits + "  " + b + "\n");
}

TEST_CASE("hash names the genotypes of a file", "[cli][hash]") {
  const test::TemporaryFolder folder;
  const std::string zoo = folder.Write(
      "zoo.pls",
      "plsc 1\nalphabet plasticoding 1\n"
      "genotype a\nrule C -> { C B }\ngenotype b\nrule C -> { C B }\n");
  const auto all = RunPlsc({"hash", zoo});
  CHECK(all.out.find("  " + zoo + "#a\n") == 32);
  CHECK(all.out.find("  " + zoo + "#b\n") != std::string::npos);
  CHECK(RunPlsc({"hash", zoo + "#b"}).out.substr(0, 32) ==
        all.out.substr(0, 32));
}

TEST_CASE("hash --phenotype is of each robot", "[cli][hash]") {
  const auto ran = RunPlsc({"hash", "-", "--phenotype"}, test::kPlasticText);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("@flat\n") != std::string::npos);
  CHECK(ran.out.find("@tilted\n") != std::string::npos);
  CHECK(ran.out.substr(0, 32) != ran.out.substr(ran.out.find('\n') + 1, 32));
  CHECK(RunPlsc({"hash", "-", "--phenotype", "--env", "no"}, test::kPlasticText)
            .exit == 2);
}

TEST_CASE("hash says what it cannot read, and goes on", "[cli][hash]") {
  const test::TemporaryFolder folder;
  const std::string a = folder.Write("a.pls", test::kPlasticText);
  const std::string bad =
      folder.Write("bad.pls", std::string("plsc 1\nrule \0", 13));
  const auto ran = RunPlsc({"hash", bad, folder / "none.pls", a});
  CHECK(ran.exit == 1);
  CHECK(std::count(ran.out.begin(), ran.out.end(), '\n') == 1);
  CHECK(RunPlsc({"hash", "-", "--phenotype"},
                "plsc 1\nalphabet plasticoding 1\niterations 30\n"
                "rule C -> { C B }\nrule B -> { B B }\n")
            .exit == 1);
  CHECK(RunPlsc({"hash"}).exit == 2);
}

}  // namespace
}  // namespace plsc
