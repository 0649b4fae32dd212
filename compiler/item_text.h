#pragma once

// The text of items as Format writes them: canonical blanks, the spelling of
// names and numbers kept, comments left out (compiler/layout.h places them).

#include <cstddef>
#include <string>
#include <vector>

#include "grammar/ast.h"

namespace plsc {

/// Characters that a line may have where a list is written on one, as in this
/// project's code.
inline constexpr std::size_t kLineWidth = 80;

/// Something that gets a line of its own between braces.
struct ItemElement {
  Span span;
  std::string text;
};

/// An item is `open`, or `open` elements `}` when it has braces.
struct ItemText {
  std::string open;  ///< up to and with '{', or all of the item
  bool has_braces = false;
  Span braces;  ///< from '{' to '}', both included
  std::vector<ItemElement> elements;
};

/// `has_comments`: whether there are comments between the item's braces. The
/// groups of an alphabet and the entries of an environment share a line only
/// when there are none.
ItemText TextOf(const ast::File& file, const ast::Item& item,
                bool has_comments);

/// The braces of an item, empty if it has none.
Span BracesOf(const ast::File& file, const ast::Item& item);

}  // namespace plsc
