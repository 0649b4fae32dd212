// The phenotype of every example in every environment that it names, kept in
// golden files beside the examples, as docs/testing-robots.md advises.

#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;

// Files of examples/ itself; examples/output is what quickstart.sh makes.
std::set<std::string> Examples(const std::string& ending) {
  std::set<std::string> files;
  for (const auto& entry :
       fs::directory_iterator(test::InRepository("examples")))
    if (entry.path().string().ends_with(ending))
      files.insert(entry.path().string());
  return files;
}

TEST_CASE("every example develops as its golden file says", "[examples]") {
  const auto genotypes = Examples(".pls");
  CHECK(genotypes.size() >= 6);
  std::vector<std::string> arguments{"test"};
  arguments.insert(arguments.end(), genotypes.begin(), genotypes.end());
  const auto ran = test::RunPlsc(arguments);
  INFO(ran.out);
  CHECK(ran.exit == 0);
  CHECK(ran.out.find("as expected\n") != std::string::npos);
}

TEST_CASE("every example has a golden file, and every golden file an example",
          "[examples]") {
  std::set<std::string> expected;
  for (const std::string& genotype : Examples(".pls"))
    expected.insert(genotype.substr(0, genotype.size() - 4) + ".golden.json");
  CHECK(Examples(".golden.json") == expected);
}

TEST_CASE("every example compiles without a warning, in any layout",
          "[examples]") {
  for (const std::string& genotype : Examples(".pls")) {
    INFO(genotype);
    const auto check = test::RunPlsc({"check", genotype});
    CHECK(check.exit == 0);
    CHECK(check.err.empty());
    const auto formatted = test::RunPlsc({"fmt", "--stdout", genotype});
    REQUIRE(formatted.exit == 0);
    const auto original =
        test::RunPlsc({"develop", genotype, "--format", "json"});
    CHECK(test::RunPlsc({"develop", "-", "--format", "json"}, formatted.out)
              .out == original.out);
  }
}

TEST_CASE("every example is laid out as plsc fmt does it", "[examples]") {
  for (const std::string& genotype : Examples(".pls")) {
    const auto checked = test::RunPlsc({"fmt", "--check", genotype});
    INFO(checked.out);
    CHECK(checked.exit == 0);
  }
}

}  // namespace
}  // namespace plsc
