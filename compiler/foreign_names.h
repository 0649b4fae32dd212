#pragma once

// Symbols as the program of the paper's authors (Revolve) names them. Users
// who know that program write them; the compiler then says which symbol of
// Table 1 is meant. They are never accepted.

#include <string>
#include <string_view>

namespace plsc {

/// "A2" for "AJ1"; empty for a word that Revolve does not use.
std::string_view PlasticodingNameFor(std::string_view revolve);

/// One sentence on the difference.
std::string ForeignNote(std::string_view revolve);

}  // namespace plsc
