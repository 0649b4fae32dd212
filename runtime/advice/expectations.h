#pragma once

// Runs the tests that a genotype file states itself (`test` items): develops
// as each says, and tells where its expectation and the development part.

#include <optional>
#include <vector>

#include "compiler/compile.h"
#include "grammar/diagnostic.h"
#include "sim/body.h"

namespace plsc {

/// Nothing when the test passes; else P4002 at the first symbol or module that
/// is otherwise, or P4001 when the string would grow beyond its limit.
/// `index` of Program::tests.
std::optional<Diagnostic> RunInlineTest(const MappedProgram& mapped,
                                        std::size_t index);

/// A developed body as tests write it, children in the order of Face.
std::vector<ExpectedModule> AsExpected(const Body& body);

}  // namespace plsc
