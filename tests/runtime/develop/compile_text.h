#pragma once

// Genotypes for tests, written as text.

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compile.h"

namespace plsc::test {

/// Compiles or fails the test with the diagnostics.
inline Program CompileText(const std::string& text) {
  const Source source("test", text);
  const Result<Program> program = Compile(source);
  if (!program) FAIL(Render(program.diagnostics(), source));
  return *program;
}

/// A genotype over X, Y, Z (replaceable) and a (terminal), axiom X, with the
/// given states, settings and rules.
inline Genotype Didactic(const std::string& rest) {
  return CompileText(
             "plsc 1\ngenotype sample\n"
             "alphabet didactic { replaceable X, Y, Z; terminal a }\n"
             "axiom X\n" +
             rest)
      .genotype;
}

/// A plasticoding genotype with the given states, settings and rules.
inline Genotype Robot(const std::string& rest) {
  return CompileText("plsc 1\ngenotype sample\nalphabet plasticoding 1\n" +
                     rest)
      .genotype;
}

}  // namespace plsc::test
