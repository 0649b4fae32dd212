#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "runtime/compare/version_difference.h"
#include "runtime/develop/growth.h"
#include "runtime/service/asks.h"
#include "runtime/service/limits.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"

namespace plsc::service {

namespace {

FileVersion VersionOf(const Request& request, const char* key,
                      const std::string& name) {
  Source source(name, LimitedText(request, key));
  auto programs = CompileAll(source);
  if (!programs) throw Refusal(programs.diagnostics(), source);
  return {std::move(source), std::move(*programs), ""};
}

/// Symbols that both would develop into, refused when they are too many.
class Budget {
 public:
  void Take(const Genotype& genotype, const Environment& environment) {
    const std::uint64_t length =
        DerivedLength(genotype, Regulate(genotype, environment));
    symbols_ += std::min(length, kMostSymbols + 1);
    if (symbols_ > kMostSymbols)
      throw Refusal(fmt::format(
          "to compare the robots takes more than {} symbols", kMostSymbols));
  }

 private:
  std::uint64_t symbols_ = 0;
};

}  // namespace

Answer Compare(const Request& request) {
  const std::string name = NameOf(request);
  const FileVersion before = VersionOf(request, "before", name + " before");
  const FileVersion after = VersionOf(request, "text", name);
  Budget budget;
  const auto difference = CompareVersions(
      before, after, [&](const Program& then, const Program& now) {
        SharedEnvironments shared = FindSharedEnvironments(then, now);
        for (const SharedEnvironment& one : shared.environments) {
          budget.Take(then.genotype, one.before);
          budget.Take(now.genotype, one.after);
        }
        return std::optional(std::move(shared));
      });
  Answer answer;
  answer.AddWritten("difference",
                    DifferenceJson(difference->texts, difference->robots));
  return answer;
}

}  // namespace plsc::service
