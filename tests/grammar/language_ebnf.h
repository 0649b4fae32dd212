#pragma once

// The EBNF of plsc 1, and its place in docs/language.md.

#include <string>

namespace plsc::testing {

/// One rule a paragraph, as PrintEbnf has it.
std::string LanguageEbnf();

/// `document` with the EBNF between its marks, `<!-- grammar: ...` and
/// `<!-- end of grammar -->`, replaced; empty when it has no such marks.
std::string WithEbnf(const std::string& document, const std::string& ebnf);

}  // namespace plsc::testing
