#pragma once

// A genotype's canonical text cut into what a run repeats: a child has all but
// one or two of its rules from its parents, so each rule is stored once. The
// whole would be 80 MB for the paper's run.

#include <string>
#include <string_view>
#include <vector>

namespace plsc {

struct GenotypeParts {
  std::string before_name;         ///< "plsc 1\n\ngenotype "
  std::string after_name;          ///< up to the first rule
  std::vector<std::string> rules;  ///< "rule C -> {\n  C\n}\n"

  friend bool operator==(const GenotypeParts&, const GenotypeParts&) = default;
};

/// Of Print(genotype), whose name is `name`. The text is before_name, the
/// name, after_name and each rule behind an empty line.
GenotypeParts SplitGenotype(std::string_view text, std::string_view name);

}  // namespace plsc
