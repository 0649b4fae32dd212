#pragma once

// What a genotype becomes in an environment, as one value with a name: the
// robot, or of an alphabet without bodies the derived string. Equal keys mean
// the same robot to the last bit of every number.

#include <optional>
#include <string>
#include <vector>

#include "runtime/develop/regulate.h"
#include "runtime/text/key.h"
#include "sim/phenotype.h"

namespace plsc {

struct Developed {
  std::optional<Phenotype> robot;
  std::vector<Symbol> string;  ///< without `robot` only

  friend bool operator==(const Developed&, const Developed&) = default;
};

/// Nothing when the string would grow beyond its limit.
std::optional<Developed> DevelopActive(const Genotype& genotype,
                                       const ActiveRules& active);

/// Of the body with the ids of its modules and of the brain, or of the string;
/// neither names nor how it developed count. `genotype` says how symbols are
/// called.
Key DevelopedKey(const Genotype& genotype, const Developed& developed);

/// Of a robot as BodyJson and BrainJson write it.
Key RobotKey(const std::string& body, const std::string& brain);
Key RobotKey(const Phenotype& robot);

}  // namespace plsc
