#pragma once

// Where things are in a JSON text, which nlohmann-json does not say, so that
// messages about a file can show the line. Looks only at brackets and quotes.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/source.h"

namespace plsc {

/// The value that `path` leads to: keys of objects, and positions in arrays as
/// decimal numbers. `text` is correct JSON; a path that leads nowhere ends at
/// the last value that is there.
Span JsonPlaceOf(std::string_view text, const std::vector<std::string>& path);
/// The key that the path ends in; of an element of an array its value.
Span JsonKeyPlaceOf(std::string_view text,
                    const std::vector<std::string>& path);

/// Brackets that a text may have around a value. Our deepest formats, and those
/// of LSP, have about ten; a library that recurses must never see a million.
inline constexpr int kMaxJsonDepth = 64;
/// The first bracket beyond that, of any text. Needs no memory.
std::optional<Span> TooDeepInJson(std::string_view text);

/// The first key that its object has already, of any text.
std::optional<Span> RepeatedJsonKey(std::string_view text);

}  // namespace plsc
