#pragma once

// Where in the text each part of a Genotype was written. The IR has no places
// (evolution writes most genotypes, and they are compared and copied), so the
// map lies beside it, numbered like it: rules by RuleIndex, symbols by their
// position in the production. Made only when somebody asks (CompileWithMap).

#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/resolve.h"
#include "grammar/ast.h"

namespace plsc {

struct RuleSpans {
  Span rule;    ///< the whole item
  Span head;    ///< the name that is rewritten
  Span clause;  ///< first to last term; empty when there is no clause
  std::vector<Span> terms;    ///< of Clause::terms
  std::vector<Span> symbols;  ///< of Rule::production, with their arguments
};

struct TestSpans {
  Span test;  ///< the whole item
  Span name;
  Span close;                 ///< '}'; empty of a body of one module
  std::vector<Span> symbols;  ///< of InlineTest::string
  std::vector<Span> modules;  ///< of InlineTest::body, with their faces
};

struct SourceMap {
  Span genotype;                 ///< its name; empty when it is not written
  std::vector<RuleSpans> rules;  ///< of Genotype::rules
  std::vector<TestSpans> tests;  ///< of Program::tests
  Span version;                  ///< `plsc 1`
  Span iterations;               ///< its number; empty when it is not written
  Span axiom;                    ///< the name; empty when it is not written
};

/// Everything in `file` is resolved, as for Lower.
SourceMap MapSource(const ast::File& file, const Resolution& resolution);

/// Symbol `position` of the production of rule `rule`, as in Occurrence.
struct SymbolPlace {
  std::uint16_t rule = 0;
  std::uint32_t position = 0;

  friend bool operator==(const SymbolPlace&, const SymbolPlace&) = default;
};

/// The symbol of a production that covers the byte `offset`, its arguments
/// counted in.
std::optional<SymbolPlace> FindSymbol(const SourceMap& map,
                                      std::uint32_t offset);

}  // namespace plsc
