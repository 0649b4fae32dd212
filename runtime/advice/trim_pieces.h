#pragma once

// What `plsc trim` may leave out of a file: rules, terms of clauses, symbols.
// A piece is a place of the text, because a rule that stands before the first
// of several genotypes belongs to all of them and goes from all or from none.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/compile.h"

namespace plsc {

enum class PieceKind : std::uint8_t { kRule, kTerm, kSymbol };

struct Piece {
  PieceKind kind{};
  Span span;
  std::vector<std::size_t> programs;  ///< that have it
};

/// The pieces of one rule of one program, numbered as Pieces::all.
struct RulePieces {
  std::size_t rule = 0;
  std::vector<std::size_t> terms;    ///< of Clause::terms
  std::vector<std::size_t> symbols;  ///< of Rule::production
};

struct Pieces {
  std::vector<Piece> all;
  std::vector<std::vector<RulePieces>> of;  ///< by program, by rule
};

/// `programs`: all that a file holds.
Pieces PiecesOf(std::span<const MappedProgram> programs);

/// By piece; a term or symbol of a rule that is left out does not count.
using Kept = std::vector<bool>;

/// The genotype with what is kept. Terms of one `and` group stay in it.
/// Nothing when a production would be empty or lose the C that it must have.
std::optional<Genotype> KeepPieces(const Genotype& genotype,
                                   const std::vector<RulePieces>& rules,
                                   const Kept& kept);

/// Where, among the connectives behind term `first` and before term `last` of
/// a clause, the one stands that joins the two when the terms between them are
/// gone: an `or` if there is one.
std::size_t JoiningConnective(const Clause& clause, std::size_t first,
                              std::size_t last);

}  // namespace plsc
