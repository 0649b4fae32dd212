// Any bytes give a golden file's content or errors, each about a place of the
// text; what is read is printed as a text that reads as the same.

#include "fuzz/require.h"
#include "runtime/compare/golden_json.h"

namespace {

using plsc::fuzz::Require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const plsc::Result<plsc::Golden> golden = plsc::ParseGolden(source);
  plsc::fuzz::RequireSound(golden.diagnostics(), source);
  if (!golden) return 0;
  const plsc::Source printed("printed", plsc::PrintGolden(*golden));
  const plsc::Result<plsc::Golden> again = plsc::ParseGolden(printed);
  Require(static_cast<bool>(again), "what is printed can be read");
  Require(*again == *golden, "what is printed means the same");
  return 0;
}
