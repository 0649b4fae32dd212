#pragma once

// Counts and summaries of what the authors' program draws, from
// tests/data/statistics.json, and their comparison with ours. A distribution
// is a map from category to count, as in {"and": 50092, "or": 50078}.

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace plsc::test {

/// One block of the file, such as "mutation_plastic".
nlohmann::json ReferenceStatistics(const std::string& block);

/// Our counts, by the names that the file gives to distributions.
class Tally {
 public:
  void Count(const std::string& distribution, const std::string& category) {
    ++counts_[distribution][category];
  }
  int operator()(const std::string& distribution,
                 const std::string& category) const;

  /// Probability that ours and theirs, an object of counts, are samples of one
  /// distribution. Categories that both have fewer than ten of together are
  /// taken as one. 0 if we counted nothing.
  double Agreement(const std::string& distribution,
                   const nlohmann::json& theirs) const;
  /// Of all distributions in `block`, those whose Agreement is not above
  /// kSignificance: "name: 1e-12". Not those in `without`.
  std::vector<std::string> Disagreements(
      const nlohmann::json& block,
      const std::set<std::string>& without = {}) const;

 private:
  std::map<std::string, std::map<std::string, int>> counts_;
};

/// Mean of a sample against a summary {"n", "mean", "sd"} of theirs: how many
/// standard errors of the difference they are apart.
double Apart(const std::vector<double>& sample, const nlohmann::json& summary);

}  // namespace plsc::test
