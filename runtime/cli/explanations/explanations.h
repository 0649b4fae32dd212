#pragma once

// What `plsc explain CODE` says of each code of grammar/codes: the meaning at
// length, a wrong example and the mended one. The texts are tables, a file for
// each group of codes; a test runs every example. SARIF takes its help from
// here.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "grammar/codes.h"

namespace plsc::cli {

/// What an example is, and so which stage gives its code.
enum class ExampleKind : std::uint8_t {
  kGenotype,    ///< compiled
  kLint,        ///< compiled, then looked at for advice (runtime/advice/lint.h)
  kDevelop,     ///< compiles, but cannot be developed
  kTest,        ///< compiles, but its own tests fail
  kTrim,        ///< compiles, but cannot be trimmed
  kImport,      ///< a genotype of the authors' program
  kExperiment,  ///< YAML, read as an experiment
  kCommand,     ///< a command line: the file itself cannot be shown
};

struct Explanation {
  Code code;
  ExampleKind kind = ExampleKind::kGenotype;
  std::string_view text;    ///< lines of at most 80 characters
  std::string_view wrong;   ///< gives the code
  std::string_view mended;  ///< does not
};

/// In the order of grammar/codes.
std::vector<Explanation> Explanations();

/// nullptr when there is none.
const Explanation* FindExplanation(Code code);

// The tables.
std::span<const Explanation> SyntaxExplanations();      ///< P11
std::span<const Explanation> NameExplanations();        ///< P20
std::span<const Explanation> RegulationExplanations();  ///< P3, P4, W
std::span<const Explanation> FileExplanations();        ///< P50
std::span<const Explanation> YamlExplanations();        ///< P51
std::span<const Explanation> HouseholdExplanations();   ///< P4003, 52

}  // namespace plsc::cli
