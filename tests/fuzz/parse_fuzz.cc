// libFuzzer target: any bytes give a program or diagnostics; what compiles
// prints to an equal program and formats to text that formats to itself.
// Built with PLSC_FUZZ=ON by clang; see tests/fuzz/CMakeLists.txt.

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "compiler/compile.h"
#include "compiler/format.h"
#include "compiler/lint.h"
#include "compiler/print.h"
#include "compiler/verify.h"

namespace {

// assert() would do, but must not depend on how the fuzzer is built.
void Require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

void CheckDiagnostics(const std::vector<plsc::Diagnostic>& diagnostics,
                      const plsc::Source& source) {
  for (const plsc::Diagnostic& diagnostic : diagnostics) {
    Require(diagnostic.code.size() == 5 && diagnostic.code != "P1199",
            "a diagnostic has a code that users may see");
    Require(diagnostic.code != "P5090", "the formatter found its own defect");
    Require(diagnostic.span.begin <= diagnostic.span.end &&
                diagnostic.span.end <= source.text().size(),
            "a diagnostic is about a place of the text");
    for (const plsc::Fix& fix : diagnostic.fixes)
      Require(fix.span.begin <= fix.span.end &&
                  fix.span.end <= source.text().size(),
              "a fix is about a place of the text");
  }
  Require(diagnostics.empty() || !plsc::Render(diagnostics, source).empty(),
          "diagnostics can be shown");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source(
      "fuzz", std::string(reinterpret_cast<const char*>(data), size));
  const plsc::Result<plsc::Program> program = plsc::Compile(source);
  CheckDiagnostics(program.diagnostics(), source);
  if (!program) {
    Require(!program.diagnostics().empty(), "no program without a reason");
    return 0;
  }
  Require(plsc::Verify(*program).empty(), "what compiles passes Verify");
  const auto mapped = plsc::CompileWithMap(source);
  Require(static_cast<bool>(mapped), "places change nothing");
  CheckDiagnostics(plsc::LintClauses(mapped->program, mapped->map), source);

  const std::string text = plsc::Print(*program);
  const plsc::Result<plsc::Program> again =
      plsc::Compile(plsc::Source("printed", text));
  Require(static_cast<bool>(again), "what is printed compiles");
  Require(*again == *program, "what is printed means the same");
  for (const bool is_compact : {false, true}) {
    plsc::FormatOptions options;
    options.compact = is_compact;
    const plsc::Result<std::string> formatted = plsc::Format(source, options);
    CheckDiagnostics(formatted.diagnostics(), source);
    Require(static_cast<bool>(formatted), "what compiles can be formatted");
  }
  return 0;
}
