#pragma once

// Where a part of a YAML scalar's text stands in the file, which has quotes,
// indentation and line breaks that the text has not.

#include <cstdint>
#include <optional>
#include <string_view>

#include "grammar/source.h"

namespace plsc {

/// `begin`: where the scalar begins in `file`, or the header of its block.
/// `text`: what it means. Blanks apart, the file must have the text as it is:
/// nothing where it has escapes.
std::optional<Span> PlaceInScalar(std::string_view file, std::uint32_t begin,
                                  std::string_view text, Span part);

}  // namespace plsc
