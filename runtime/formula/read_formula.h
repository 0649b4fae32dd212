#pragma once

// Text to a checked formula.

#include <string_view>

#include "grammar/result.h"
#include "runtime/formula/formula.h"

namespace plsc {

/// A number of the quantities. Errors, all that can be found, name unknown
/// quantities with the nearest one, wrong numbers of arguments, truth where a
/// number is needed, and what can be no number whatever the quantities are.
/// Their places are in `text`.
Result<Formula> ReadFormula(std::string_view text);

}  // namespace plsc
