#pragma once

// The parser's state: the tree so far and the parts of the item at hand.
// Actions fill in parts; an item is added to the tree only when all of it has
// matched, so that a broken item leaves nothing but unused pool elements.

#include <cstdint>
#include <string_view>
#include <vector>

#include "grammar/ast.h"
#include "grammar/reporter.h"
#include "grammar/syntax_error.h"

namespace plsc::grammar {

/// Thrown to leave an item; what is wrong is in Builder::reporter.
struct SyntaxFailure {};

/// Deepest nesting of an expected body. The parser calls itself once a level,
/// so some limit keeps it from the end of the stack; robots of 15 modules
/// cannot reach 15.
inline constexpr std::size_t kMaxBodyDepth = 100;

struct Builder {
  ast::File file;
  Reporter reporter;

  const char* base = nullptr;      ///< of the text
  std::uint32_t previous_end = 0;  ///< end of the last token

  // The item at hand.
  Span keyword;
  Span name;
  Span open;   ///< '{'
  Span close;  ///< '}'
  ast::Value value;
  ast::Bounds bounds;
  ast::Connective connective = ast::Connective::kNone;
  ast::Term term;
  ast::Rule rule;
  ast::Alphabet alphabet;
  ast::Sense sense;
  ast::Environment environment;
  ast::Test test;
  Span face;                             ///< of the module that follows
  std::vector<std::uint32_t> body_path;  ///< open modules of File::nodes
  ast::SettingKey setting_key{};
  ast::Entry entry;
  bool is_replaceable = false;

  /// Forgets what the item before left behind.
  void BeginItem(Span item_keyword);
  /// Adds the item of `kind` that is `index` in the vector of its kind.
  void EndItem(ast::ItemKind kind, std::size_t index);
  /// Reads a number that matched rules.h; reports one that no double holds.
  void TakeNumber(Span span);
  /// `true` and `false` are other languages' words for values.
  void CheckTermValue();
  /// Records what is wrong at `offset` and leaves the item.
  [[noreturn]] void Fail(SyntaxError error, std::uint32_t offset);
};

}  // namespace plsc::grammar
