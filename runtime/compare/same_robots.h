#pragma once

// Whether two genotypes develop into the same robots, whatever is sensed: the
// proof that an edit changed nothing. Every environment that a clause of
// either tells apart is developed with both.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/program.h"
#include "runtime/text/key.h"

namespace plsc {

/// Environments in which the same rules of both are active.
struct ComparedRegime {
  std::string where;  ///< the first of them: "inclined = True"; "always"
  int count = 0;      ///< of environments that clauses tell apart
  std::vector<std::string> named;  ///< those of the file among them
  Key before;                      ///< DevelopedKey
  Key after;
};

enum class Compared : std::uint8_t {
  kAll,    ///< every environment that clauses tell apart
  kNamed,  ///< those that the named ones are among
};

/// In the order of their first environments. The genotypes have equal states
/// and alphabets. Nothing when there are too many environments to develop
/// (runtime/develop/regimes.h), or a string grows beyond its limit.
std::optional<std::vector<ComparedRegime>> CompareRegimes(
    const Genotype& before, const Genotype& after,
    const std::vector<NamedEnvironment>& named,
    Compared compared = Compared::kAll);

/// Whether all of them have the same robot before and after.
bool AreSame(const std::vector<ComparedRegime>& regimes);

}  // namespace plsc
