// How many genotypes a second one core compiles and develops, over the authors'
// cases: one development is one genotype in one environment, from IR to body,
// brain and all descriptors. Reports; asserts nothing.
//
//   develop_bench [--smoke]

#include <fmt/format.h>

#include <cstring>
#include <ctime>
#include <functional>

#include "compiler/compile.h"
#include "runtime/descriptors.h"
#include "runtime/develop.h"
#include "runtime/environment.h"
#include "tests/runtime/reference_cases.h"

namespace plsc {
namespace {

struct Case {
  Source source;
  Genotype genotype;
  Environment environment;
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
      cases.push_back({source, program->genotype, *environment});
    }
  return cases;
}

// CPU time of this thread: wall time on a shared machine says little.
double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec);
}

// `work` does all cases once and returns something that depends on them.
void Time(const char* name, std::size_t cases, double seconds,
          const std::function<double()>& work) {
  double sum = work();  // warm up
  const double begin = CpuSeconds();
  double elapsed = 0;
  std::size_t rounds = 0;
  do {
    sum += work();
    ++rounds;
    elapsed = CpuSeconds() - begin;
  } while (elapsed < seconds);
  const double each = elapsed / static_cast<double>(rounds * cases);
  fmt::print("{:<34} {:>9.0f} genotypes/s {:>8.2f} us each  ({})\n", name,
             1 / each, 1e6 * each, sum > 0 ? "ok" : "?");
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

double CompileEach(const std::vector<Case>& cases) {
  double sum = 0;
  for (const Case& one : cases)
    sum += static_cast<double>(Compile(one.source)->genotype.rules.size());
  return sum;
}

}  // namespace
}  // namespace plsc

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::strcmp(argv[1], "--smoke") == 0;
  const double seconds = smoke ? 0 : 3;
  const std::vector<plsc::Case> cases = plsc::LoadCases();
  fmt::print("{} cases\n", cases.size());
  plsc::Time("compile (text to IR)", cases.size(), seconds,
             [&] { return CompileEach(cases); });
  plsc::Time("develop (IR to body and brain)", cases.size(), seconds,
             [&] { return plsc::DevelopAll(cases, false); });
  plsc::Time("develop and describe", cases.size(), seconds,
             [&] { return plsc::DevelopAll(cases, true); });
  return 0;
}
