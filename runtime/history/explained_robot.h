#pragma once

// A robot on its way to the page that explains it (explain_json): developed
// with its history in each environment, if that is not too much to show.

#include <string>
#include <vector>

#include "compiler/compile.h"
#include "grammar/expected.h"
#include "runtime/history/explain_json.h"

namespace plsc {

/// Most symbols that a robot's rewritings may have together: a page of more
/// elements answers slowly to the pointer. The paper's have hundreds.
inline constexpr std::size_t kMostExplainedSymbols = 20000;

struct NotExplained {
  enum class Why : std::uint8_t {
    kGrown,         ///< development outgrows its limit in `environment`
    kTooManyToShow  ///< more than kMostExplainedSymbols
  };
  Why why{};
  NamedEnvironment environment;  ///< the first that was too much
};

/// `mapped` is of `source`, with the alphabet that has bodies.
Expected<ExplainedRobot, NotExplained> ExplainRobot(
    std::string title, const Source& source, const MappedProgram& mapped,
    const std::vector<NamedEnvironment>& environments);

/// "the rewritings of gecko have more than ... symbols": kTooManyToShow.
std::string TooManyToShow(const std::string& title);

}  // namespace plsc
