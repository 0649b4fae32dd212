#pragma once

// A genotype file cut into items, and rules, environments and tests into their
// parts, with every byte kept: what a merge of texts takes from one version or
// another. A comment belongs to what it stands before, or behind on the same
// line, as in compiler/layout.h.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/ast.h"

namespace plsc {

/// What a part says: `A1(0.5, 2, 3, 1)`, the term `and hot = True`, the entry
/// `hot = True`. Numbers are spelled alike here.
struct PartContent {
  std::string name;
  std::vector<std::string> values;

  friend bool operator==(const PartContent&, const PartContent&) = default;
};

/// "A1(0.5, 2, 3, 1)".
std::string PartText(const PartContent& content);

/// A symbol, an entry or a term with its connective.
struct WrittenPart {
  PartContent content;
  std::string before;  ///< blanks and comments
  std::string text;
  std::string after;  ///< a comment behind it on the same line
};

/// Text: before, open, parts, close, after.
struct WrittenItem {
  ast::ItemKind kind{};
  /// Of items of one kind and name, such as "environment tilted"; of rules,
  /// which may have equal ones, "rule C".
  std::string key;
  Span span;
  std::string before;  ///< blanks and comments
  /// All of an item without parts; else up to and with its '{'.
  std::string open;
  std::string content;             ///< of `open`, without comments
  std::vector<WrittenPart> terms;  ///< of a rule's clause; written in `open`
  std::vector<WrittenPart> parts;
  std::string close;  ///< from behind the last part on, with '}'
  std::string after;  ///< a comment behind it on the same line
};

struct WrittenFile {
  std::vector<WrittenItem> items;  ///< `plsc 1` is the first
  std::string end;                 ///< blanks and comments
};

/// Of a file that parses without errors.
WrittenFile CutIntoItems(const ast::File& file);
/// Of a text that compiles, or an empty one.
WrittenFile ReadItems(const Source& source);
/// How many items `genotype` there are.
std::size_t CountGenotypes(const WrittenFile& file);

/// Without what stands before and after it.
std::string CoreText(const WrittenItem& item);

/// "# brick", in order, of any text of a genotype.
std::vector<std::string> CommentsIn(std::string_view text);

}  // namespace plsc
