#pragma once

// The environment that inlay hints are about, as the user chose it: the name of
// an `environment` item, or STATE=VALUE,...; nothing chosen is each genotype's
// first.

#include <optional>
#include <string>
#include <vector>

#include "compiler/program.h"
#include "runtime/lsp/section.h"

namespace plsc::lsp {

/// The environments of a section whose entries are complete and right.
std::vector<NamedEnvironment> EnvironmentsOf(const Section& section);

/// What `chosen` means for a section; nothing when it means nothing there.
std::optional<NamedEnvironment> ChosenFor(const Section& section,
                                          const std::string& chosen);

}  // namespace plsc::lsp
