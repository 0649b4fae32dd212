#include "compiler/compile.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "compiler/check.h"
#include "compiler/lower.h"
#include "compiler/resolve.h"
#include "compiler/scope.h"
#include "compiler/suppress.h"
#include "compiler/verify.h"
#include "grammar/parse.h"

namespace plsc {

namespace {

using Diagnostics = std::vector<Diagnostic>;

void Append(Diagnostics more, Diagnostics* all) {
  std::move(more.begin(), more.end(), std::back_inserter(*all));
}

bool HasErrors(const Diagnostics& diagnostics) {
  return std::any_of(
      diagnostics.begin(), diagnostics.end(),
      [](const Diagnostic& d) { return d.severity == Severity::kError; });
}

void SortByPosition(Diagnostics* diagnostics) {
  std::stable_sort(diagnostics->begin(), diagnostics->end(),
                   [](const Diagnostic& a, const Diagnostic& b) {
                     return a.span.begin < b.span.begin;
                   });
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

// Fills `map` when there is one: most callers never look at places.
Result<Program> CompileInto(const Source& source, const CompileOptions& options,
                            SourceMap* map) {
  ParseResult parsed = Parse(source);
  Diagnostics diagnostics = std::move(parsed.diagnostics);
  const ast::File& file = parsed.file;
  // Nothing of the file was read (binary, empty, another version).
  if (file.is_incomplete && file.items.empty()) return diagnostics;

  Scope scope = Declare(file);
  Resolution resolution = Resolve(file, scope);
  Append(std::move(scope.diagnostics), &diagnostics);
  Append(std::move(resolution.diagnostics), &diagnostics);
  Append(Check(file, scope, resolution, options), &diagnostics);
  if (HasErrors(diagnostics)) {
    SortByPosition(&diagnostics);
    return diagnostics;
  }

  Append(CheckClauses(file, scope, resolution), &diagnostics);
  const Suppressions suppressions(file);
  diagnostics = suppressions.Keep(std::move(diagnostics));
  Append(suppressions.diagnostics(), &diagnostics);
  SortByPosition(&diagnostics);
  Program program = Lower(file, scope, resolution);
  AssertVerified(program, options);
  if (map != nullptr) *map = MapSource(file, resolution);
  return {std::move(program), std::move(diagnostics)};
}

}  // namespace

Result<Program> Compile(const Source& source, const CompileOptions& options) {
  return CompileInto(source, options, nullptr);
}

Result<MappedProgram> CompileWithMap(const Source& source,
                                     const CompileOptions& options) {
  SourceMap map;
  Result<Program> program = CompileInto(source, options, &map);
  if (!program) return program.diagnostics();
  return {MappedProgram{std::move(*program), std::move(map)},
          program.diagnostics()};
}

}  // namespace plsc
