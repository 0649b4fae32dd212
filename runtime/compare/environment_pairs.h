#pragma once

// The environments in which two versions of a genotype can be compared: all
// that the clauses of either tell apart. The versions may declare other states,
// or the same ones in another order.

#include <string>
#include <vector>

#include "compiler/program.h"

namespace plsc {

/// Environments in which each version has the same rules active; one of them.
struct SharedEnvironment {
  std::string text;                ///< "inclined=True,hot=False", or "any"
  std::vector<std::string> names;  ///< of those that either file declares
  Environment before;              ///< in the states of the first version
  Environment after;               ///< in those of the second
  bool is_any = false;             ///< neither version senses anything
};

struct SharedEnvironments {
  std::vector<SharedEnvironment> environments;
  /// Why these are not all; empty if they are. Then they are those that both
  /// files declare.
  std::string limitation;
};

SharedEnvironments FindSharedEnvironments(const Program& before,
                                          const Program& after);

}  // namespace plsc
