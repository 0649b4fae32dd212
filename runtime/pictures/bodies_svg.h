#pragma once

// The bodies of one genotype in several environments as one picture, with what
// differs from the first one marked (body_difference) and a legend.

#include <optional>
#include <string>
#include <vector>

#include "runtime/develop/regulate.h"
#include "sim/body.h"

namespace plsc {

struct DrawnBody {
  std::string name;    ///< of the environment
  std::string senses;  ///< what is sensed there; may be empty
  Body body;
  /// By module, the rule that made it, or kNoRule (the axiom).
  std::vector<RuleIndex> rules;
};

/// A complete SVG file, modules in the colours of their types.
std::string BodiesSvg(const std::string& title,
                      const std::vector<DrawnBody>& bodies);

/// The same in the colours of rules; `rule_texts` by rule, for the legend.
std::string BodiesByRuleSvg(const std::string& title,
                            const std::vector<DrawnBody>& bodies,
                            const std::vector<std::string>& rule_texts);

/// The rules that made a module of any of the bodies, in order; kNoRule last.
std::vector<RuleIndex> RulesOf(const std::vector<DrawnBody>& bodies);

}  // namespace plsc
