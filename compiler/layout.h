#pragma once

// How Format places items and comments. Works on a file that compiles.
//
// A comment belongs to the item that it stands before, or behind on the same
// line; inside braces, likewise to the symbol. What stands in the middle of a
// line's worth of text (between `iterations` and its number) moves before it.
// Empty lines between items of a kind, and between what stands in braces, stay,
// one of several.

#include <span>
#include <string>

#include "compiler/alphabet.h"
#include "grammar/ast.h"

namespace plsc {

/// `alphabets` are those of the file's genotypes, in file order. Items do not
/// move from one section (compiler/sections.h) to another.
std::string Layout(const ast::File& file,
                   std::span<const AlphabetPtr> alphabets, bool is_compact);

}  // namespace plsc
