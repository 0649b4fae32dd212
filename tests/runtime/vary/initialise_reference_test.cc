// Every distribution of the authors' initialisation, over 20,000 genotypes of
// each kind: plastic, plastic with two states, Baseline.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "compiler/print.h"
#include "runtime/vary/initialise.h"
#include "tests/runtime/vary/chi_square.h"
#include "tests/runtime/vary/kolmogorov.h"
#include "tests/runtime/vary/reference_statistics.h"

namespace plsc {

namespace {

using test::KolmogorovPValue;
using test::kSignificance;
using test::NormalCdf;
using test::Tally;
using test::UniformCdf;

constexpr std::uint64_t kReferenceGenotypes = 20000;
// Of a mean: one of the about 45 compared here would be further off in 1 of
// 350 writings of this file.
constexpr double kStandardErrors = 4;

using Samples = std::map<std::string, std::vector<double>>;

Genotype ReferenceSample(const GenotypeOptions& options, std::uint64_t id) {
  Rng rng({9101, 0, id, Purpose::kInitialise});
  return Initialise(options, rng);
}

// As many as the authors' summaries take.
constexpr std::size_t kReferenceSamples = 50000;

std::string CategoryName(Category category) {
  return "symbols " + std::to_string(static_cast<int>(category));
}

/// "A1.w"; single parameters are called value there.
std::string ParameterName(const SymbolInfo& symbol, std::size_t index) {
  return symbol.name + "." +
         (symbol.parameters.size() == 1 ? "value"
                                        : symbol.parameters[index].name);
}

void CountClause(const Clause& clause, const std::vector<State>& states,
                 Tally& tally) {
  std::string form;
  for (std::size_t i = 0; i < clause.terms.size(); ++i) {
    const Term& term = clause.terms[i];
    const std::string& name = states[static_cast<std::size_t>(term.state)].name;
    const std::string value = term.value == 1 ? "True" : "False";
    if (i > 0) {
      const std::string connective =
          clause.connectives[i - 1] == Connective::kAnd ? "and" : "or";
      tally.Count("operators", connective);
      form += " " + connective + " ";
    }
    tally.Count("term_values", value);
    tally.Count("term_names", name);
    form += name + "=" + value;
  }
  tally.Count("clause_term_counts", std::to_string(clause.terms.size()));
  tally.Count("clause_forms", form);
}

void CountSymbol(const Symbol& symbol, const Alphabet& alphabet, Tally& tally,
                 Samples& samples) {
  const SymbolInfo& info = alphabet[symbol.id];
  tally.Count(CategoryName(info.category), info.name);
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const double value = symbol.arguments[i];
    const std::string name = ParameterName(info, i);
    if (info.parameters[i].is_integer)
      tally.Count(name, std::to_string(static_cast<int>(value)));
    else if (std::vector<double>& sample = samples[name];
             sample.size() < kReferenceSamples)
      sample.push_back(value);
  }
}

struct Drawn {
  Tally tally;
  Samples samples;
};

Drawn DrawAll(const GenotypeOptions& options,
              std::uint64_t genotypes = kReferenceGenotypes) {
  Drawn drawn;
  for (std::uint64_t id = 0; id < genotypes; ++id) {
    const Genotype genotype = ReferenceSample(options, id);
    const std::size_t groups = genotype.rules.back().production.size() / 5;
    drawn.tally.Count("groups_per_genotype", std::to_string(groups));
    for (const Rule& rule : genotype.rules) {
      if (options.encoding == Encoding::kPlasticoding)
        CountClause(rule.clause, genotype.states, drawn.tally);
      for (const Symbol& symbol : rule.production)
        // C is not drawn: it stands in front of every rule of C.
        if (symbol.id != plasticoding::kC)
          CountSymbol(symbol, *genotype.alphabet, drawn.tally, drawn.samples);
    }
  }
  return drawn;
}

/// All symbols of a category have an equal chance, so their counts vary
/// independently only within it: the number of groups is common to all.
std::map<std::string, nlohmann::json> ByCategory(const nlohmann::json& counts) {
  std::map<std::string, nlohmann::json> categories;
  const Alphabet& alphabet = *PlasticodingAlphabet();
  for (const SymbolInfo& symbol : alphabet.symbols())
    if (symbol.name != "C")
      categories[CategoryName(symbol.category)][symbol.name] =
          counts.at(symbol.name);
  return categories;
}

/// Of the distribution that Table 1 says.
double AgreementWithTable(const std::string& parameter,
                          const std::vector<double>& sample) {
  if (parameter.starts_with("mutate_"))
    return KolmogorovPValue(sample, NormalCdf);
  const bool is_weight =
      parameter.ends_with(".w") || parameter.ends_with(".value");
  const double low = is_weight ? -1 : 1;
  const double high = is_weight ? 1 : 10;
  return KolmogorovPValue(sample,
                          [&](double x) { return UniformCdf(x, low, high); });
}

}  // namespace

TEST_CASE("Initialisation draws as the authors' program does",
          "[initialise][slow]") {
  struct Row {
    const char* block;
    GenotypeOptions options;
  };
  std::vector<Row> rows = {{"initializer_plastic", {}},
                           {"initializer_two_states", {}},
                           {"initializer_baseline", {}}};
  rows[1].options.states.push_back({"hot", StateType::kBool, 0, 0, {}});
  rows[2].options.encoding = Encoding::kBaseline;
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.block) {
      const nlohmann::json theirs = test::ReferenceStatistics(row.block);
      const Drawn ours = DrawAll(row.options);
      CHECK(ours.tally.Disagreements(
                theirs, {"symbol_counts", "params", "move_ref_values"}) ==
            std::vector<std::string>{});
      CHECK(ours.tally.Disagreements(theirs.at("move_ref_values")) ==
            std::vector<std::string>{});
      for (const auto& [name, counts] :
           ByCategory(theirs.at("symbol_counts"))) {
        CAPTURE(name, counts.dump());
        CHECK(ours.tally.Agreement(name, counts) > kSignificance);
      }
      for (const auto& [name, summary] : theirs.at("params").items()) {
        CAPTURE(name);
        REQUIRE(ours.samples.contains(name));
        const std::vector<double>& sample = ours.samples.at(name);
        CHECK(test::Apart(sample, summary) < kStandardErrors);
        CHECK(AgreementWithTable(name, sample) > kSignificance);
      }
    }
  }
}

TEST_CASE("Other ways to initialise are told from the authors'",
          "[initialise][slow]") {
  // That the comparison above can fail.
  const nlohmann::json theirs =
      test::ReferenceStatistics("initializer_plastic");
  const auto disagreements = [&](const GenotypeOptions& options) {
    return DrawAll(options, 2000)
        .tally.Disagreements(theirs,
                             {"symbol_counts", "params", "move_ref_values"});
  };
  GenotypeOptions options;
  options.min_groups = 2;
  const std::vector<std::string> of_groups = disagreements(options);
  REQUIRE(of_groups.size() == 1);
  CHECK(of_groups[0].starts_with("groups_per_genotype: "));
  options = {};
  options.min_initial_terms = 2;
  const std::vector<std::string> of_terms = disagreements(options);
  REQUIRE(of_terms.size() == 2);
  CHECK(of_terms[0].starts_with("clause_forms: "));
  CHECK(of_terms[1].starts_with("clause_term_counts: "));
}

}  // namespace plsc
