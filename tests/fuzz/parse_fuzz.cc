// Any bytes give programs, one a genotype of the file, or errors, each about a
// place of the text.

#include <algorithm>

#include "compiler/compile.h"
#include "fuzz/require.h"
#include "grammar/parse.h"

namespace {

using plsc::fuzz::Require;

bool HasError(const std::vector<plsc::Diagnostic>& diagnostics) {
  for (const plsc::Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == plsc::Severity::kError) return true;
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const auto programs = plsc::CompileAll(source);
  plsc::fuzz::RequireSound(programs.diagnostics(), source);
  Require(HasError(programs.diagnostics()) != static_cast<bool>(programs),
          "there are errors, or else programs");
  if (!programs) return 0;
  const std::size_t named = plsc::Parse(source).file.genotypes.size();
  Require(programs->size() == std::max<std::size_t>(named, 1),
          "every genotype gives a program");
  const auto mapped = plsc::CompileAllWithMap(source);
  Require(mapped && mapped->size() == programs->size(),
          "places change nothing");
  for (std::size_t i = 0; i < programs->size(); ++i)
    Require((*mapped)[i].program == (*programs)[i], "places change nothing");
  return 0;
}
