#include "runtime/compare/version_difference.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"

namespace plsc {
namespace {

FileVersion VersionOfText(const std::string& genotypes,
                          const std::string& chosen = "") {
  Source source("a.pls", "plsc 1\nalphabet plasticoding 1\n" + genotypes);
  auto programs = CompileAll(source);
  REQUIRE(programs);
  std::vector<Program> meant;
  for (Program& program : *programs)
    if (chosen.empty() || program.genotype.name == chosen)
      meant.push_back(std::move(program));
  return {std::move(source), std::move(meant), chosen};
}

constexpr const char* kOne = "genotype one\nrule C -> { C add_front B }\n";
constexpr const char* kTwo = "genotype two\nrule C -> { C add_left B }\n";

TEST_CASE("versions are compared genotype by genotype",
          "[version_difference]") {
  const FileVersion before = VersionOfText(std::string(kOne) + kTwo);
  const FileVersion after = VersionOfText(
      std::string(kTwo) + "genotype three\nrule C -> { C add_right B }\n");
  const auto difference =
      CompareVersions(before, after, FindSharedEnvironments);
  REQUIRE(difference);
  REQUIRE(difference->robots.size() == 3);
  CHECK(difference->robots[0].genotype == "two");
  CHECK_FALSE(difference->robots[0].is_different());
  CHECK(difference->robots[1].genotype == "three");
  CHECK(difference->robots[1].kind == ItemChangeKind::kAdded);
  CHECK(difference->robots[2].genotype == "one");
  CHECK(difference->robots[2].kind == ItemChangeKind::kRemoved);
  CHECK(difference->is_different());
}

TEST_CASE("the only genotypes are a pair whatever their names",
          "[version_difference]") {
  const auto same = CompareVersions(VersionOfText(kOne),
                                    VersionOfText("genotype other\n"
                                                  "rule C -> { C add_front B }"
                                                  "\n"),
                                    FindSharedEnvironments);
  REQUIRE(same);
  REQUIRE(same->robots.size() == 1);
  CHECK_FALSE(same->is_different());
  // Also two of one file.
  const std::string both = std::string(kOne) + kTwo;
  const auto chosen =
      CompareVersions(VersionOfText(both, "one"), VersionOfText(both, "two"),
                      FindSharedEnvironments);
  REQUIRE(chosen);
  CHECK(chosen->is_different());
  CHECK(chosen->texts.size() == 1);
}

TEST_CASE("whoever chooses environments may end a comparison",
          "[version_difference]") {
  CHECK_FALSE(CompareVersions(
      VersionOfText(kOne), VersionOfText(kOne),
      [](const Program&, const Program&) { return std::nullopt; }));
}

}  // namespace
}  // namespace plsc
