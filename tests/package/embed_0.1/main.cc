// A program of your own that compiles, develops and simulates: docs/library.md.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "compiler/compile.h"
#include "runtime/develop.h"
#include "runtime/evaluation.h"
#include "runtime/scenario_profile.h"

int main(int count, char** words) {
  if (count != 2) return std::puts("usage: embed GENOTYPE.pls"), 2;
  std::ifstream file(words[1]);
  const plsc::Source source(words[1], {std::istreambuf_iterator(file), {}});
  const plsc::Result<plsc::Program> program = plsc::Compile(source);
  if (!program) {
    for (const plsc::Diagnostic& problem : program.diagnostics())
      std::fputs(plsc::Render(problem, source).c_str(), stderr);
    return 1;
  }
  for (const auto& [name, environment] : program->environments) {
    const auto robot = plsc::Develop(program->genotype, environment);
    if (!robot) continue;  // it would outgrow its limit
    std::printf("%s: %zu modules\n", name.c_str(), robot->body.modules.size());
  }
  const plsc::Scenario scenario = plsc::PaperScenario();
  for (const auto& season : plsc::Evaluate(program->genotype, scenario).seasons)
    std::printf("%s: %.4f m/s\n", season.season.c_str(),
                season.fitness.value_or(-1));
}
