#pragma once

// All advice on a genotype: by its clauses (compiler/lint.h) and by what its
// rules develop into. Nothing here is an error, and evolved genotypes have
// much of it; people who write by hand want to know.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "grammar/diagnostic.h"
#include "runtime/develop/regulate.h"

namespace plsc {

/// Every warning that no comment silences, sorted by position; without those
/// of Compile. `compiled` is all that `source` holds.
///   W3003, W3004, W3005  see compiler/lint.h
///   W4001  in some environment the string would grow beyond its limit.
///   W4002  a symbol that no environment expresses, or a rule that rewrites
///          nothing in any (runtime/advice/lint_expression.h).
///   W4003  a controller command that somewhere changes another joint than the
///          one before it.
///   W4004  a rule of C that rewriting repeats in place.
std::vector<Diagnostic> Lint(std::span<const MappedProgram> compiled,
                             const Source& source);

/// The same of one genotype, neither sorted nor silenced: for who must not wait
/// for all of a file.
std::vector<Diagnostic> LintGenotype(const MappedProgram& compiled);

/// P4001: in the environment called `where` the string would have `length`
/// symbols. Points at the `iterations` item, or at the first rule of the axiom
/// when the file leaves it out.
Diagnostic GrowthError(const MappedProgram& compiled, const ActiveRules& active,
                       std::uint64_t length, const std::string& where);

}  // namespace plsc
