// A file of several genotypes becomes as many trees, each with a copy of what
// stands before the first, so that no later stage knows of sections. The trees
// share the source text: spans mean the same bytes in all of them, and a
// diagnostic about what is shared is found once a genotype and told once
// (SortAndDropRepeated). Copies are the price, which is why CompileEach bounds
// what may be shared.

#include "compiler/sections.h"

#include <cassert>
#include <cstdint>

namespace plsc {

namespace {

// Appends the elements of `range` to another pool, and says where they are.
template <typename T>
ast::Range CopyRange(const std::vector<T>& from, ast::Range range,
                     std::vector<T>* to) {
  const auto first = static_cast<std::uint32_t>(to->size());
  const auto begin = from.begin() + static_cast<std::ptrdiff_t>(range.first);
  to->insert(to->end(), begin,
             begin + static_cast<std::ptrdiff_t>(range.count));
  return {first, range.count};
}

// Copies items with the pools that they refer to.
class Copier {
 public:
  Copier(const ast::File& from, ast::File* to) : from_(from), to_(to) {}

  void Copy(const ast::Item& item) {
    using enum ast::ItemKind;
    switch (item.kind) {
      case kGenotype:
        return Add(item, from_.genotypes, &to_->genotypes);
      case kAlphabet:
        Add(item, from_.alphabets, &to_->alphabets);
        return CopyDeclarations(&to_->alphabets.back().declarations);
      case kSense: {
        Add(item, from_.senses, &to_->senses);
        ast::Range& values = to_->senses.back().values;
        values = CopyRange(from_.names, values, &to_->names);
        return;
      }
      case kLet:
        return Add(item, from_.lets, &to_->lets);
      case kAxiom:
        return Add(item, from_.axioms, &to_->axioms);
      case kSetting:
        return Add(item, from_.settings, &to_->settings);
      case kRule: {
        Add(item, from_.rules, &to_->rules);
        ast::Rule& rule = to_->rules.back();
        rule.terms = CopyRange(from_.terms, rule.terms, &to_->terms);
        return CopySymbols(&rule.symbols);
      }
      case kEnvironment: {
        Add(item, from_.environments, &to_->environments);
        ast::Range& entries = to_->environments.back().entries;
        entries = CopyRange(from_.entries, entries, &to_->entries);
        return;
      }
      case kTest: {
        Add(item, from_.tests, &to_->tests);
        ast::Test& test = to_->tests.back();
        test.nodes = CopyRange(from_.nodes, test.nodes, &to_->nodes);
        return CopySymbols(&test.symbols);
      }
    }
  }

 private:
  template <typename T>
  void Add(const ast::Item& item, const std::vector<T>& from,
           std::vector<T>* to) {
    ast::Item copy = item;
    copy.index = static_cast<std::uint32_t>(to->size());
    to_->items.push_back(copy);
    to->push_back(from[item.index]);
  }

  void CopySymbols(ast::Range* symbols) {
    *symbols = CopyRange(from_.symbols, *symbols, &to_->symbols);
    for (std::uint32_t k = 0; k < symbols->count; ++k) {
      ast::Range& arguments = to_->symbols[symbols->first + k].arguments;
      arguments = CopyRange(from_.arguments, arguments, &to_->arguments);
    }
  }

  void CopyDeclarations(ast::Range* declarations) {
    *declarations =
        CopyRange(from_.declarations, *declarations, &to_->declarations);
    for (std::uint32_t k = 0; k < declarations->count; ++k) {
      ast::Range& parameters =
          to_->declarations[declarations->first + k].parameters;
      parameters = CopyRange(from_.parameters, parameters, &to_->parameters);
    }
  }

  const ast::File& from_;
  ast::File* to_;
};

}  // namespace

std::vector<ast::File> SplitIntoSections(const ast::File& file) {
  assert(file.genotypes.size() > 1);
  ast::File shared;
  shared.text = file.text;
  shared.version = file.version;
  shared.version_number = file.version_number;
  shared.is_incomplete = file.is_incomplete;
  std::vector<ast::File> sections;
  for (const ast::Item& item : file.items) {
    if (item.kind == ast::ItemKind::kGenotype) sections.push_back(shared);
    Copier(file, sections.empty() ? &shared : &sections.back()).Copy(item);
  }
  return sections;
}

}  // namespace plsc
