#pragma once

// What a genotype file expects of its own development: `test` items. Data
// only; runtime/advice/expectations develops and compares.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/genotype.h"
#include "grammar/enum_names.h"

namespace plsc {

/// A symbol of a test's expected string.
struct ExpectedSymbol {
  Symbol symbol;
  /// False where the text leaves the arguments out: any will do.
  bool has_arguments = true;

  friend bool operator==(const ExpectedSymbol&,
                         const ExpectedSymbol&) = default;
};

/// Where a module is mounted on its parent; alphabetical. Only the core has
/// something at its back: what is mounted when its other three are taken.
enum class Face : std::uint8_t { kBack, kFront, kLeft, kRight };
inline constexpr int kFaces = 4;
inline constexpr EnumNames<Face, 4> kFaceNames{{{Face::kBack, "back"},
                                                {Face::kFront, "front"},
                                                {Face::kLeft, "left"},
                                                {Face::kRight, "right"}}};

/// A module of a test's expected body; a parent stands before its children.
struct ExpectedModule {
  SymbolId symbol{};         ///< C, B, A1, A2 or T
  int depth = 0;             ///< 0 the core
  Face face = Face::kFront;  ///< of the parent; no meaning for the core

  friend bool operator==(const ExpectedModule&,
                         const ExpectedModule&) = default;
};

/// `test flat_string in flat after 2 -> { C B }`: an expectation that
/// travels with the genotype. Of the string, or else of the body.
struct InlineTest {
  std::string name;
  std::string place;  ///< name of the environment; empty if nothing is sensed
  Environment environment;
  std::optional<int> after;  ///< rewritings; absent: all of them
  std::vector<ExpectedSymbol> string;
  std::vector<ExpectedModule> body;  ///< empty: the string is expected

  friend bool operator==(const InlineTest&, const InlineTest&) = default;
};

}  // namespace plsc
