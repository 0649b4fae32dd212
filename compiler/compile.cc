// The stages in their order, and what they may rely on. Each reports what it
// can see and leaves out what an earlier one has reported; lowering begins only
// if nobody found an error, in this section or before it, since half of a
// genotype is none. Warnings about clauses are made of what can be lowered.
// Comments that silence warnings come last, over the whole file, as they may
// stand in another section than what they silence.

#include "compiler/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "compiler/check.h"
#include "compiler/limits.h"
#include "compiler/lower.h"
#include "compiler/resolve.h"
#include "compiler/scope.h"
#include "compiler/sections.h"
#include "compiler/suppress.h"
#include "compiler/verify.h"
#include "grammar/parse.h"
#include "grammar/reporter.h"

namespace plsc {

namespace {

using Diagnostics = std::vector<Diagnostic>;

void Append(Diagnostics more, Diagnostics* all) {
  std::move(more.begin(), more.end(), std::back_inserter(*all));
}

// What compiles passes Verify. Tests and fuzzers ask Verify themselves, in
// every build; here it is asked only in builds that check the standard library
// too (debug, sanitize), because it is a pass over all of the IR, a tenth of
// compiling, to find defects of ours that the stages before have ruled out.
void AssertVerified([[maybe_unused]] const Program& program,
                    [[maybe_unused]] const CompileOptions& options) {
#ifdef _GLIBCXX_ASSERTIONS
  assert(options.allow_out_of_range || Verify(program).empty());
#endif
}

// One section, or the file as a whole. Fills `map` when there is one: most
// callers never look at places. Nothing when there are errors.
std::optional<Program> CompileSection(const ast::File& file,
                                      const CompileOptions& options,
                                      SourceMap* map,
                                      Diagnostics* diagnostics) {
  Scope scope = Declare(file);
  Resolution resolution = Resolve(file, scope);
  Diagnostics found = std::move(scope.diagnostics);
  Append(std::move(resolution.diagnostics), &found);
  Append(Check(file, scope, resolution, options), &found);
  const bool is_broken = HasErrors(found) || HasErrors(*diagnostics);
  Append(std::move(found), diagnostics);
  if (is_broken) return std::nullopt;

  Append(CheckClauses(file, scope, resolution), diagnostics);
  Program program = Lower(file, scope, resolution);
  AssertVerified(program, options);
  if (map != nullptr) *map = MapSource(file, resolution);
  return program;
}

// A name is how FILE#NAME chooses a genotype.
Diagnostics CheckNames(const ast::File& file) {
  Reporter reporter;
  std::unordered_map<std::string_view, Span> names;
  for (const ast::Naming& genotype : file.genotypes) {
    const auto [first, is_new] =
        names.emplace(file.Text(genotype.name), genotype.name);
    if (is_new) continue;
    reporter
        .Report(Code::kRepeatedName, genotype.name,
                fmt::format("genotype '{}' is declared twice", first->first))
        .WithOther(first->second, "first declared here");
  }
  return reporter.Take();
}

// What is shared is copied into each genotype, so that a small file could ask
// for more memory than there is.
std::size_t SharedBytes(const ast::File& file) {
  std::size_t shared = 0;
  for (const ast::Item& item : file.items) {
    if (item.kind == ast::ItemKind::kGenotype) break;
    shared += item.span.end - item.span.begin;
  }
  return shared;
}

Diagnostic TooMuchShared(const ast::File& file) {
  return Diagnostic(
             Code::kLimit, file.genotypes[0].name,
             fmt::format(
                 "{} genotypes share {} bytes of text: together more than {} "
                 "MiB",
                 file.genotypes.size(), SharedBytes(file),
                 kMaxSharedText >> 20U))
      .WithLabel("what stands before this belongs to each genotype")
      .WithHelp("spread the genotypes over several files");
}

// Calls `take` with the program and the map of each genotype. The diagnostics,
// sorted; nothing was taken, or too little, when there are errors among them.
template <typename Take>
Diagnostics CompileEach(const Source& source, const CompileOptions& options,
                        bool wants_map, Take take) {
  ParseResult parsed = Parse(source);
  Diagnostics diagnostics = std::move(parsed.diagnostics);
  const ast::File& file = parsed.file;
  // Nothing of the file was read (binary, empty, another version).
  if (file.is_incomplete && file.items.empty()) return diagnostics;

  SourceMap map;
  const auto compile = [&](const ast::File& section) {
    auto program = CompileSection(section, options, wants_map ? &map : nullptr,
                                  &diagnostics);
    if (program) take(*std::move(program), std::move(map));
  };
  if (file.genotypes.size() > 1) {
    Append(CheckNames(file), &diagnostics);
    if (SharedBytes(file) * file.genotypes.size() > kMaxSharedText) {
      diagnostics.push_back(TooMuchShared(file));
      SortAndDropRepeated(&diagnostics);
      return diagnostics;
    }
    for (const ast::File& section : SplitIntoSections(file)) {
      // Only errors may keep a genotype from being compiled.
      if (diagnostics.size() >= kMaxReported && HasErrors(diagnostics)) break;
      compile(section);
    }
  } else {
    compile(file);
  }
  // What belongs to several genotypes is found wrong in each.
  SortAndDropRepeated(&diagnostics);
  if (HasErrors(diagnostics)) return diagnostics;
  const Suppressions suppressions(file);
  diagnostics = suppressions.Keep(std::move(diagnostics));
  Append(suppressions.diagnostics(), &diagnostics);
  SortAndDropRepeated(&diagnostics);
  return diagnostics;
}

}  // namespace

Result<std::vector<Program>> CompileAll(const Source& source,
                                        const CompileOptions& options) {
  std::vector<Program> programs;
  Diagnostics diagnostics = CompileEach(
      source, options, false, [&](Program program, const SourceMap&) {
        programs.push_back(std::move(program));
      });
  if (HasErrors(diagnostics)) return diagnostics;
  return {std::move(programs), std::move(diagnostics)};
}

Result<std::vector<MappedProgram>> CompileAllWithMap(
    const Source& source, const CompileOptions& options) {
  std::vector<MappedProgram> programs;
  Diagnostics diagnostics =
      CompileEach(source, options, true, [&](Program program, SourceMap map) {
        programs.push_back({std::move(program), std::move(map)});
      });
  if (HasErrors(diagnostics)) return diagnostics;
  return {std::move(programs), std::move(diagnostics)};
}

Diagnostic SeveralGenotypes(const Source& source) {
  const ast::File file = Parse(source).file;
  assert(file.genotypes.size() > 1);
  const Span second = file.genotypes[1].name;
  return Diagnostic(
             Code::kSeveralGenotypes, second,
             fmt::format("this file holds {} genotypes", file.genotypes.size()))
      .WithLabel("the second one")
      .WithHelp(fmt::format("choose one by its name, as in '{}#{}'",
                            source.name(), file.Text(second)));
}

namespace {

template <typename T>
Result<T> TheOnly(Result<std::vector<T>> all, const Source& source) {
  if (!all) return all.diagnostics();
  if (all->size() > 1) return Diagnostics{SeveralGenotypes(source)};
  return {std::move(all->front()), all.diagnostics()};
}

}  // namespace

Result<Program> Compile(const Source& source, const CompileOptions& options) {
  return TheOnly(CompileAll(source, options), source);
}

Result<MappedProgram> CompileWithMap(const Source& source,
                                     const CompileOptions& options) {
  return TheOnly(CompileAllWithMap(source, options), source);
}

}  // namespace plsc
