#pragma once

// The environments of a program that somebody means: by the names that its file
// declares, or written out.

#include <optional>
#include <string>
#include <vector>

#include "compiler/program.h"
#include "grammar/result.h"

namespace plsc {

/// `text` is a name that the file declares, or "state=value,..." as
/// ParseEnvironment reads it, which is called as it is printed.
Result<NamedEnvironment> FindEnvironment(const Program& program,
                                         const Source& text);

/// Where nobody says which: all that the file declares, or the only one when
/// nothing is sensed, "any". Nothing when it has to be said.
std::optional<std::vector<NamedEnvironment>> UsualEnvironments(
    const Program& program);

/// What is sensed there, unless the name says it.
std::string SensesOf(const NamedEnvironment& named,
                     const std::vector<State>& states);

/// "inclined=False,hot=False": how one is written out.
std::string ExampleOfEnvironment(const std::vector<State>& states);

}  // namespace plsc
