// How many genotypes a second one core compiles and develops, over the authors'
// cases: one development is one genotype in one environment, from IR to body
// and brain. Also its three stages alone, and its heap allocations. Reports;
// asserts nothing.
//
//   develop_bench [--smoke]

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>

#include "compiler/compile.h"
#include "compiler/environment_text.h"
#include "runtime/develop/descriptors.h"
#include "runtime/develop/develop.h"
#include "tests/allocations.h"
#include "tests/bench/stopwatch.h"
#include "tests/runtime/develop/reference_cases.h"

namespace plsc {
namespace {

struct Case {
  Source source;
  Genotype genotype;
  Environment environment;
  ActiveRules active;
  SymbolString string;
};

std::vector<Case> LoadCases() {
  std::vector<Case> cases;
  for (const std::string& set : test::ReferenceSets())
    for (const test::Json& reference_case : test::ReadReferenceCases(set)) {
      Source source("case", test::GenotypeText(reference_case));
      const Result<Program> program = Compile(source);
      const Source senses("--env", test::EnvironmentText(reference_case));
      const Result<Environment> environment =
          ParseEnvironment(senses, program->genotype.states);
      const Genotype& genotype = program->genotype;
      const ActiveRules active = Regulate(genotype, *environment);
      cases.push_back(
          {source, genotype, *environment, active, *Derive(genotype, active)});
    }
  return cases;
}

// `work` does all cases once and returns something that depends on them.
void Time(const char* name, std::size_t cases, double seconds,
          const std::function<double()>& work) {
  const double each =
      bench::SecondsEach(seconds, work) / static_cast<double>(cases);
  fmt::print("{:<34} {:>9.0f} genotypes/s {:>8.2f} us each\n", name, 1 / each,
             1e6 * each);
}

double CompileEach(const std::vector<Case>& cases) {
  double sum = 0;
  for (const Case& one : cases)
    sum += static_cast<double>(Compile(one.source)->genotype.rules.size());
  return sum;
}

double RegulateAll(const std::vector<Case>& cases) {
  double sum = 0;
  for (const Case& one : cases)
    sum += static_cast<double>(
        Regulate(one.genotype, one.environment).rules.size());
  return sum;
}

double DeriveAll(const std::vector<Case>& cases) {
  double sum = 0;
  for (const Case& one : cases)
    sum += static_cast<double>(Derive(one.genotype, one.active)->size());
  return sum;
}

double ReadAll(const std::vector<Case>& cases) {
  double sum = 0;
  for (const Case& one : cases)
    sum += static_cast<double>(
        Develop(one.genotype, one.string).body.modules.size());
  return sum;
}

double DevelopAll(const std::vector<Case>& cases, bool describe) {
  double sum = 0;
  for (const Case& one : cases) {
    const auto phenotype = Develop(one.genotype, one.environment);
    sum += static_cast<double>(phenotype->body.modules.size());
    if (describe)
      sum += DescribeBody(phenotype->body).coverage +
             DescribeBrain(*phenotype).avg_period;
  }
  return sum;
}

// Heap: how often a development asks for memory, and what a robot keeps.
void ReportMemory(const std::vector<Case>& cases) {
  const auto count = static_cast<double>(cases.size());
  double symbols = 0;
  double bytes = 0;
  std::size_t most = 0;
  const std::size_t begin = test::AllocationCount();
  for (const Case& one : cases) {
    const std::size_t before = test::AllocationCount();
    const auto robot = Develop(one.genotype, one.environment);
    most = std::max(most, test::AllocationCount() - before);
    symbols += static_cast<double>(one.string.size());
    bytes += static_cast<double>(
        sizeof(Phenotype) + robot->body.modules.capacity() * sizeof(Module) +
        robot->brain.nodes.capacity() * sizeof(Node) +
        robot->brain.connections.capacity() * sizeof(Connection));
  }
  const auto allocations = static_cast<double>(test::AllocationCount() - begin);
  fmt::print(
      "{:.0f} symbols a string; {:.1f} allocations a development (at "
      "most {}), {:.3f} a symbol; {:.0f} bytes a robot\n",
      symbols / count, allocations / count, most, allocations / symbols,
      bytes / count);
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const double seconds = smoke ? 0 : 2;
  const std::vector<plsc::Case> cases = plsc::LoadCases();
  fmt::print("{} cases\n", cases.size());
  const auto time = [&](const char* name, const auto& work) {
    plsc::Time(name, cases.size(), seconds, [&] { return work(cases); });
  };
  time("compile (text to IR)", plsc::CompileEach);
  time("regulate", plsc::RegulateAll);
  time("derive", plsc::DeriveAll);
  time("late development", plsc::ReadAll);
  time("develop (all three)",
       [](const auto& all) { return plsc::DevelopAll(all, false); });
  time("develop and describe",
       [](const auto& all) { return plsc::DevelopAll(all, true); });
  plsc::ReportMemory(cases);
  return 0;
}
