#pragma once

// What the header of a file declares: the alphabet, the states, the constants
// and the settings. First stage after parsing; rules and environments are
// resolved against it.

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/genotype.h"
#include "grammar/ast.h"
#include "grammar/diagnostic.h"

namespace plsc {

struct Constant {
  std::string_view name;
  Span span;
  double value = 0;
  bool is_integer = false;  ///< written without '.' and exponent
};

struct Scope {
  /// Everything of the genotype but its rules. Its alphabet is null when the
  /// file declares none that is known; symbols cannot be judged then.
  Genotype header;
  std::vector<Span> state_spans;  ///< where each of header.states is declared
  std::vector<Constant> constants;
  /// By name, for files that mention thousands of them a million times. Names
  /// are texts of the file.
  std::unordered_map<std::string_view, StateId> state_ids;
  std::unordered_map<std::string_view, std::size_t> constant_ids;
  /// Of each state the places of its values, none but of an enum.
  std::vector<std::unordered_map<std::string_view, std::size_t>> value_ids;
  Span max_terms_span;
  Span max_rules_span;
  std::vector<Diagnostic> diagnostics;

  std::optional<StateId> FindState(std::string_view name) const;
  const Constant* FindConstant(std::string_view name) const;
  /// Index into State::values.
  std::optional<std::size_t> FindValue(StateId state,
                                       std::string_view name) const;
};

Scope Declare(const ast::File& file);

}  // namespace plsc
