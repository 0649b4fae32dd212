#pragma once

// What may stand where the cursor is, by the words before it in the same item.
// By words and not by the grammar, because an item that is being typed is
// broken nearly all of the time.

#include <string>
#include <string_view>
#include <vector>

#include "grammar/source.h"

namespace plsc::lsp {

enum class Wanted : std::uint8_t {
  kNothing,
  kItem,           ///< the keyword of an item
  kHead,           ///< a symbol that rules may rewrite
  kAxiom,          ///< a symbol without parameters
  kSymbol,         ///< of a production
  kConstant,       ///< an argument
  kClauseOrBrace,  ///< `if` or `{`
  kState,          ///< of a clause
  kComparison,     ///< of `subject`
  kValue,          ///< of `subject`
  kConnective,     ///< and, or, then
  kBrace,          ///< `{`
  kEntry,          ///< a state of an environment, none of `given`
  kType,           ///< of a state
  kAlphabet,       ///< plasticoding
  kTruth,          ///< True or False
  kTestWord,       ///< in, after, ->
  kEnvironment,    ///< the name of one
  kExpectation,    ///< `{` or body
  kModule,         ///< of an expected body
  kFace,           ///< or a closing brace
};

struct CompletionContext {
  Wanted wanted = Wanted::kNothing;
  std::string_view subject;             ///< the state
  std::vector<std::string_view> given;  ///< states
  Span word;  ///< what is being typed, up to the cursor; empty: nothing yet
};

CompletionContext ContextAt(std::string_view text, std::uint32_t offset);

}  // namespace plsc::lsp
