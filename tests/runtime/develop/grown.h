#pragma once

// A genotype developed with its history, for tests of what explains it.

#include <catch2/catch.hpp>
#include <string>

#include "compiler/compile.h"
#include "runtime/history/history_view.h"

namespace plsc::test {

/// Owns what a HistoryView refers to.
struct Grown {
  Source source;
  MappedProgram mapped;
  Environment environment;
  History history;

  HistoryView view() const {
    return {source, mapped.program.genotype, mapped.map, environment, history};
  }
  const Trace& trace() const { return *history.trace; }
};

/// `text` as the file "robot.pls", developed in `environment`; fails the test
/// when it does not compile.
inline Grown Grow(const std::string& text, const Environment& environment) {
  Source source("robot.pls", text);
  Result<MappedProgram> mapped = CompileWithMap(source);
  if (!mapped) FAIL(Render(mapped.diagnostics(), source));
  auto history = DevelopWithHistory(mapped->program.genotype, environment);
  REQUIRE(history);
  return {std::move(source), std::move(*mapped), environment,
          std::move(*history)};
}

/// One rule of C, always active, rewritten once; line 4 of the file.
inline Grown GrowProduction(const std::string& symbols,
                            const std::string& settings = "") {
  return Grow("plsc 1 genotype robot alphabet plasticoding 1\niterations 1 " +
                  settings + "\n\nrule C -> { C " + symbols + " }\n",
              Environment{});
}

/// Two rules of C, of which the second needs `hot`, and one of B, which B's of
/// the first iteration are replaced by.
inline const char* const kTwoGenerations =
    "plsc 1 genotype robot alphabet plasticoding 1\n"
    "sense hot: bool iterations 2\n"
    "rule C -> { C B }\n"
    "rule C -> if hot = True then { C add_left T(0.5) }\n"
    "rule B -> { add_front A1(0.5, 2, 3, 4) mutate_amp(1) }\n"
    "rule T -> if hot = False then { B }\n";

}  // namespace plsc::test
