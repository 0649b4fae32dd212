// Bodies and brains of 20,000 fresh genotypes of each kind, against those that
// the authors' program developed of its own: initialisation, regulation, both
// developments and the descriptors in one.

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <vector>

#include "runtime/develop/derive.h"
#include "runtime/develop/descriptors.h"
#include "runtime/develop/develop.h"
#include "runtime/vary/initialise.h"
#include "tests/runtime/vary/chi_square.h"
#include "tests/runtime/vary/reference_statistics.h"

namespace plsc {

namespace {

constexpr std::uint64_t kDevelopedGenotypes = 20000;
// Of the means of some 35 quantities of four kinds, which hang together.
constexpr double kDevelopedErrors = 4;

struct Developed {
  test::Tally tally;
  std::map<std::string, std::vector<double>> values;
};

void CountPhenotype(const Phenotype& robot, Developed& developed) {
  const BodyDescriptors body = DescribeBody(robot.body);
  developed.tally.Count("body_size_histogram",
                        std::to_string(body.absolute_size));
  for (const NamedValue& value : List(body))
    developed.values[std::string(value.name)].push_back(value.value);
  for (const NamedValue& value : List(DescribeBrain(robot)))
    developed.values[std::string(value.name)].push_back(value.value);
  double loops = 0;
  for (const Connection& connection : robot.brain.connections)
    if (connection.source == connection.destination) ++loops;
  const auto count = [](const auto& all) {
    return static_cast<double>(all.size());
  };
  developed.values["nodes"].push_back(count(robot.brain.nodes));
  developed.values["connections"].push_back(count(robot.brain.connections));
  developed.values["loops"].push_back(loops);
}

Developed DevelopAll(const GenotypeOptions& options, double inclined) {
  Developed developed;
  for (std::uint64_t id = 0; id < kDevelopedGenotypes; ++id) {
    Rng rng({9110, 0, id, Purpose::kInitialise});
    const Genotype genotype = Initialise(options, rng);
    Environment environment;
    environment.values.assign(genotype.states.size(), inclined);
    const auto string = Derive(genotype, Regulate(genotype, environment));
    REQUIRE(string);
    developed.values["developed_string_length"].push_back(
        static_cast<double>(string->size()));
    CountPhenotype(Develop(genotype, *string), developed);
  }
  return developed;
}

GenotypeOptions Options(Encoding encoding, bool move_to_new) {
  GenotypeOptions options;
  options.encoding = encoding;
  options.development.move_to_new = move_to_new;
  return options;
}

}  // namespace

TEST_CASE("Fresh robots are as many-shaped as the authors'",
          "[develop][slow]") {
  struct Row {
    const char* block;
    GenotypeOptions options;
    double inclined;
  };
  const std::vector<Row> rows = {
      {"developed_plastic_plane", {}, 0},
      {"developed_plastic_tilted5", {}, 1},
      {"developed_baseline", Options(Encoding::kBaseline, false), 0},
      {"developed_plastic_plane_move_to_new",
       Options(Encoding::kPlasticoding, true), 0}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.block) {
      const nlohmann::json theirs = test::ReferenceStatistics(row.block);
      const Developed ours = DevelopAll(row.options, row.inclined);
      CHECK(ours.tally.Agreement("body_size_histogram",
                                 theirs.at("body_size_histogram")) >
            test::kSignificance);
      CHECK(theirs.at("summaries").size() > 25);
      for (const auto& [name, summary] : theirs.at("summaries").items()) {
        CAPTURE(name);
        REQUIRE(ours.values.contains(name));
        CHECK(test::Apart(ours.values.at(name), summary) < kDevelopedErrors);
      }
    }
  }
}

TEST_CASE("Robots of the other mounting rule are told from the authors'",
          "[develop][slow]") {
  // That the comparison above can fail.
  const nlohmann::json theirs =
      test::ReferenceStatistics("developed_plastic_plane");
  const Developed ours = DevelopAll(Options(Encoding::kPlasticoding, true), 0);
  CHECK(ours.tally.Agreement("body_size_histogram",
                             theirs.at("body_size_histogram")) <
        test::kSignificance);
  CHECK(test::Apart(ours.values.at("limbs"),
                    theirs.at("summaries").at("limbs")) > kDevelopedErrors);
}

}  // namespace plsc
