// Bytes choose a program, whatever they are (tests/compiler/random_genotype):
// it passes Verify, and printed it compiles to itself, bit for bit.

#include "compiler/compile.h"
#include "compiler/print.h"
#include "compiler/random_genotype.h"
#include "compiler/verify.h"
#include "fuzz/require.h"

namespace {

using plsc::fuzz::Require;

// As many bytes a number as its size needs, so that a byte more or less
// changes one choice; zeros when there are no more.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size)
      : next_(data), end_(data + size) {}

  std::uint32_t Take(std::uint32_t most) {
    std::uint32_t number = 0;
    for (; most > 0; most >>= 8U)
      number = number << 8U | (next_ == end_ ? 0U : *next_++);
    return number;
  }

 private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  Bytes bytes(data, size);
  const plsc::Program program = plsc::testing::RandomProgram(
      [&](std::uint32_t most) { return bytes.Take(most); });
  Require(plsc::Verify(program).empty(), "the generator keeps the invariants");
  const plsc::Source printed("printed", plsc::Print(program));
  const auto compiled = plsc::Compile(printed);
  plsc::fuzz::RequireSound(compiled.diagnostics(), printed);
  Require(static_cast<bool>(compiled), "what is printed compiles");
  Require(*compiled == program, "what is printed means the same");
  return 0;
}
