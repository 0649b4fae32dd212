#pragma once

// A genotype grown in several environments, ready to be drawn: bodies and
// brains side by side, the modules with the rules that made them.

#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "runtime/develop/trace.h"
#include "runtime/pictures/bodies_svg.h"
#include "runtime/pictures/brain_svg.h"

namespace plsc {

struct DrawnRobot {
  std::vector<DrawnBody> bodies;  ///< by environment
  std::vector<DrawnBrain> brains;

  /// `history` has a trace.
  void Add(const NamedEnvironment& named, const History& history,
           const std::vector<State>& states);
};

/// "rule 2: B, if hot = True (line 12)", by rule: the legend of
/// BodiesByRuleSvg.
std::vector<std::string> RuleTexts(const Source& source,
                                   const MappedProgram& mapped);

}  // namespace plsc
