#pragma once

// Mutation of texts by words and lines, for targets that look at what
// compiles: of a program whose bytes are changed one by one, hardly any still
// is a program. Knows no grammar. Only beside libFuzzer.

#include <cstdint>
#include <string>

namespace plsc::fuzz {

/// One change: a word takes the place of another of its kind (a name of a
/// name, a number of a number), or a line is repeated, moved or dropped, or a
/// comment put in. `text` is not empty.
std::string MutateText(const std::string& text, std::uint32_t seed);

}  // namespace plsc::fuzz
