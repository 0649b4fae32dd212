#pragma once

// What a genotype file means: the genotype, the environments that the file
// names, and what it expects of them. A file of several genotypes means
// several programs (compiler/sections.h).

#include <string>
#include <vector>

#include "compiler/expectation.h"
#include "compiler/genotype.h"

namespace plsc {

/// `environment tilted { inclined = True }`; a value for every state.
struct NamedEnvironment {
  std::string name;
  Environment environment;

  friend bool operator==(const NamedEnvironment&,
                         const NamedEnvironment&) = default;
};

struct Program {
  Genotype genotype;
  std::vector<NamedEnvironment> environments;
  std::vector<InlineTest> tests;

  friend bool operator==(const Program&, const Program&) = default;
};

}  // namespace plsc
