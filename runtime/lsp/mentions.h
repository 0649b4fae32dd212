#pragma once

// Every name in a document: what kind of thing it names, where that is
// declared. Definition, references, rename, highlights and colours are all
// answers of this one list.

#include <string_view>
#include <vector>

#include "runtime/lsp/section.h"

namespace plsc::lsp {

enum class NameKind : std::uint8_t {
  kGenotype,
  kAlphabet,
  kState,
  kValue,  ///< of an enum state
  kConstant,
  kSymbol,
  kParameter,  ///< of a symbol of the file's own alphabet
  kEnvironment,
  kTest,
  kFace,
};

struct Mention {
  Span span;
  NameKind kind{};
  /// Where it is declared; empty when it is not, or built in.
  Span declaration;
  std::string_view name;
  bool is_module = false;    ///< kSymbol: replaceable
  bool is_built_in = false;  ///< kSymbol, kAlphabet, kFace
  bool is_head = false;      ///< kSymbol: the head of a rule

  bool is_declaration() const { return span == declaration; }
  bool is_declared() const { return declaration.end > 0; }
};

/// Whether both name the same thing.
bool NameTheSame(const Mention& a, const Mention& b);

/// By position. What several sections share is listed once.
std::vector<Mention> MentionsOf(const std::vector<Section>& sections);

}  // namespace plsc::lsp
