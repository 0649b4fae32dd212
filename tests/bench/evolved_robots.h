#pragma once

// The robots of tests/data/evolved.pls, grown for flat or for inclined ground.

#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/develop/develop.h"
#include "sim/overlap.h"

namespace plsc::bench {

/// But for those that have no joints there or overlap.
inline std::vector<Phenotype> EvolvedRobots(bool is_inclined) {
  const std::string path = PLSC_SOURCE_DIR "/tests/data/evolved.pls";
  std::ifstream file(path);
  const Source source(path, {std::istreambuf_iterator(file), {}});
  const Result<std::vector<Program>> programs = CompileAll(source);
  if (!programs) throw std::runtime_error("cannot compile " + path);
  std::vector<Phenotype> robots;
  for (const Program& program : *programs) {
    const Genotype& genotype = program.genotype;
    const std::optional<Phenotype> robot = Develop(
        genotype, Environment{std::vector<double>(genotype.states.size(),
                                                  is_inclined ? 1.0 : 0.0)});
    if (!robot) continue;
    const Assembly assembly = Assemble(robot->body);
    if (!assembly.hinges.empty() && FindOverlaps(assembly).empty())
      robots.push_back(*robot);
  }
  return robots;
}

}  // namespace plsc::bench
