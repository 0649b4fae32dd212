#pragma once

// An environment written as text: `inclined=True,hot=False`, the form of the
// command line's --env.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/genotype.h"
#include "grammar/result.h"
#include "grammar/source.h"

namespace plsc {

/// A value for every state of `states`; a missing one, one given twice, or
/// one of the wrong type is an error. States that the genotype does not sense
/// are no error but a warning: an environment may have more to it than one
/// robot senses.
Result<Environment> ParseEnvironment(const Source& text,
                                     const std::vector<State>& states);

/// What `text` ("True", "30.5", "wet") means as a value of `state`; nothing
/// when it is no value of that type.
std::optional<double> ParseStateValue(std::string_view text,
                                      const State& state);
/// "True or False", "a number in -40..60", "one of dry, wet".
std::string ExpectedValue(const State& state);

}  // namespace plsc
