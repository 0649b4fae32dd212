#pragma once

// What a genotype file means: the genotype and the environments that the file
// names.

#include <string>
#include <vector>

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

  friend bool operator==(const Program&, const Program&) = default;
};

}  // namespace plsc
