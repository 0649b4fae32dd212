#pragma once

// A genotype of a document as the server looks at it, compiled or broken: its
// tree, what its header declares, and which names were found.

#include <cstdint>
#include <vector>

#include "compiler/resolve.h"
#include "compiler/scope.h"
#include "grammar/ast.h"

namespace plsc::lsp {

struct Section {
  std::uint32_t begin = 0;  ///< of its `genotype` item; 0 of a file's only one
  ast::File file;           ///< with what it shares with others
  Scope scope;
  Resolution resolution;
};

/// At least one. A file whose genotypes share more text than Compile takes
/// (P3002) is looked at as if it were one genotype.
std::vector<Section> SectionsOf(const ast::File& file);

}  // namespace plsc::lsp
