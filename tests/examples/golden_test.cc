// The phenotype of every example in every environment that it names, kept in
// tests/examples/golden. PLSC_UPDATE_GOLDEN=1 rewrites the files; look at the
// difference before you commit it.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::set<fs::path> Files(const std::string& folder,
                         const std::string& extension) {
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::InRepository(folder)))
    if (entry.path().extension() == extension) files.insert(entry.path());
  return files;
}

// One robot a line of `plsc develop`, an array a file, laid out so that a
// difference can be read.
std::string DevelopAll(const fs::path& genotype) {
  const auto ran =
      test::RunPlsc({"develop", genotype.string(), "--format", "json"});
  INFO(ran.err);
  REQUIRE(ran.exit == 0);
  Json robots = Json::array();
  std::istringstream lines(ran.out);
  for (std::string line; std::getline(lines, line);)
    robots.push_back(Json::parse(line));
  return robots.dump(1) + "\n";
}

TEST_CASE("every example develops as its golden file says", "[examples]") {
  const auto genotypes = Files("examples", ".pls");
  CHECK(genotypes.size() >= 6);
  for (const fs::path& genotype : genotypes) {
    const fs::path golden =
        fs::path(test::InRepository("tests/examples/golden")) /
        (genotype.stem().string() + ".json");
    const std::string developed = DevelopAll(genotype);
    if (std::getenv("PLSC_UPDATE_GOLDEN") != nullptr)
      std::ofstream(golden) << developed;
    INFO(golden);
    CHECK(developed == test::ReadFile(golden));
  }
}

TEST_CASE("no golden file is without its example", "[examples]") {
  std::set<fs::path> expected;
  for (const fs::path& genotype : Files("examples", ".pls"))
    expected.insert(genotype.stem());
  for (const fs::path& golden : Files("tests/examples/golden", ".json"))
    CHECK(expected.contains(golden.stem()));
}

TEST_CASE("every example compiles without a warning, in any layout",
          "[examples]") {
  for (const fs::path& genotype : Files("examples", ".pls")) {
    INFO(genotype);
    const auto check = test::RunPlsc({"check", genotype.string()});
    CHECK(check.exit == 0);
    CHECK(check.err.empty());
    const auto formatted =
        test::RunPlsc({"fmt", "--stdout", genotype.string()});
    REQUIRE(formatted.exit == 0);
    const auto original =
        test::RunPlsc({"develop", genotype.string(), "--format", "json"});
    CHECK(test::RunPlsc({"develop", "-", "--format", "json"}, formatted.out)
              .out == original.out);
  }
}

}  // namespace
}  // namespace plsc
