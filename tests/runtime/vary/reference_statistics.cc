#include "tests/runtime/vary/reference_statistics.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "tests/runtime/vary/chi_square.h"

namespace plsc::test {

namespace {

// Chi-square's approximation wants about five expected in each of two samples.
constexpr int kRare = 10;

}  // namespace

nlohmann::json ReferenceStatistics(const std::string& block) {
  std::ifstream file(PLSC_SOURCE_DIR "/tests/data/statistics.json");
  return nlohmann::json::parse(file).at(block);
}

int Tally::operator()(const std::string& distribution,
                      const std::string& category) const {
  const auto counts = counts_.find(distribution);
  if (counts == counts_.end()) return 0;
  const auto count = counts->second.find(category);
  return count == counts->second.end() ? 0 : count->second;
}

double Tally::Agreement(const std::string& distribution,
                        const nlohmann::json& theirs) const {
  const auto found = counts_.find(distribution);
  if (found == counts_.end()) return 0;
  std::map<std::string, std::pair<int, int>> both;
  for (const auto& [category, count] : found->second)
    both[category].first = count;
  for (const auto& [category, count] : theirs.items())
    both[category].second = count.get<int>();
  std::vector<int> our_counts;
  std::vector<int> their_counts;
  std::pair<int, int> rare = {0, 0};
  for (const auto& [category, counts] : both) {
    const auto& [ours, other] = counts;
    if (ours + other < kRare) {
      rare.first += ours;
      rare.second += other;
      continue;
    }
    our_counts.push_back(ours);
    their_counts.push_back(other);
  }
  our_counts.push_back(rare.first);
  their_counts.push_back(rare.second);
  // What can only turn out one way agrees.
  if (both.size() == 1) return 1;
  return PValue(our_counts, their_counts);
}

std::vector<std::string> Tally::Disagreements(
    const nlohmann::json& block, const std::set<std::string>& without) const {
  std::vector<std::string> disagreements;
  for (const auto& [name, theirs] : block.items()) {
    if (!theirs.is_object() || theirs.empty() || without.contains(name))
      continue;
    const double agreement = Agreement(name, theirs);
    if (!(agreement > kSignificance))
      disagreements.push_back(fmt::format("{}: {:.3g}", name, agreement));
  }
  return disagreements;
}

double Apart(const std::vector<double>& sample, const nlohmann::json& summary) {
  const auto n = static_cast<double>(sample.size());
  const double mean = std::accumulate(sample.begin(), sample.end(), 0.0) / n;
  double squares = 0;
  for (const double x : sample) squares += (x - mean) * (x - mean);
  const double variance = squares / (n - 1);
  const double their_sd = summary.at("sd").get<double>();
  const double error = std::sqrt(
      variance / n + their_sd * their_sd / summary.at("n").get<double>());
  return std::abs(mean - summary.at("mean").get<double>()) / error;
}

}  // namespace plsc::test
