#include "runtime/lsp/section.h"

#include <algorithm>
#include <utility>

#include "compiler/limits.h"
#include "compiler/sections.h"

namespace plsc::lsp {

namespace {

Section Resolved(ast::File file, std::uint32_t begin) {
  Section section;
  section.begin = begin;
  section.file = std::move(file);
  section.scope = Declare(section.file);
  section.resolution = Resolve(section.file, section.scope);
  return section;
}

// Where each genotype item begins, and how many bytes stand before the first.
struct Begins {
  std::vector<std::uint32_t> genotypes;
  std::size_t shared = 0;
};

Begins BeginsOf(const ast::File& file) {
  Begins begins;
  for (const ast::Item& item : file.items) {
    if (item.kind == ast::ItemKind::kGenotype)
      begins.genotypes.push_back(item.span.begin);
    else if (begins.genotypes.empty())
      begins.shared += item.span.end - item.span.begin;
  }
  return begins;
}

}  // namespace

std::vector<Section> SectionsOf(const ast::File& file) {
  std::vector<Section> sections;
  const Begins begins = BeginsOf(file);
  const bool is_too_much =
      begins.shared * begins.genotypes.size() > kMaxSharedText;
  if (begins.genotypes.size() < 2 || is_too_much) {
    sections.push_back(Resolved(file, 0));
    return sections;
  }
  std::vector<ast::File> parts = SplitIntoSections(file);
  for (std::size_t i = 0; i < parts.size(); ++i)
    sections.push_back(Resolved(std::move(parts[i]), begins.genotypes[i]));
  return sections;
}

}  // namespace plsc::lsp
