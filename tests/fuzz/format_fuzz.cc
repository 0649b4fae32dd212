// What compiles is formatted, in both layouts, to a text that means the same,
// that formats to itself, and that the other layout turns into its own.

#include "compiler/compile.h"
#include "compiler/format.h"
#include "compiler/print.h"
#include "fuzz/require.h"

namespace {

using plsc::fuzz::Require;

std::string Formatted(const plsc::Source& source, bool is_compact) {
  plsc::FormatOptions options;
  options.compact = is_compact;
  const plsc::Result<std::string> formatted = plsc::Format(source, options);
  plsc::fuzz::RequireSound(formatted.diagnostics(), source);
  Require(static_cast<bool>(formatted), "what compiles can be formatted");
  return *formatted;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const auto programs = plsc::CompileAll(source);
  if (!programs) return 0;
  const plsc::Source wide("wide", Formatted(source, false));
  const plsc::Source compact("compact", Formatted(source, true));
  for (const plsc::Source* text : {&wide, &compact}) {
    const auto again = plsc::CompileAll(*text);
    Require(again && *again == *programs, "formatting keeps the meaning");
  }
  Require(Formatted(wide, false) == wide.text(), "formats to itself");
  Require(Formatted(compact, true) == compact.text(), "formats to itself");
  for (const plsc::Program& program : *programs) {
    const auto again =
        plsc::Compile(plsc::Source("printed", plsc::Print(program)));
    Require(again && *again == program, "printing keeps the meaning");
  }
  return 0;
}
