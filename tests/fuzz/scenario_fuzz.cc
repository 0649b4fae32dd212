// Any bytes give a scenario or errors, each about a place of the text; what is
// read is printed as a text that reads as the same scenario.

#include "fuzz/require.h"
#include "runtime/scenario/scenario.h"
#include "runtime/scenario/scenario_yaml.h"

namespace {

using plsc::fuzz::Require;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const plsc::Source source = plsc::fuzz::AsSource(data, size);
  const plsc::Result<plsc::Scenario> scenario = plsc::ParseScenario(source);
  plsc::fuzz::RequireSound(scenario.diagnostics(), source);
  if (!scenario) return 0;
  const plsc::Source printed("printed", plsc::PrintScenario(*scenario));
  const plsc::Result<plsc::Scenario> again = plsc::ParseScenario(printed);
  Require(static_cast<bool>(again), "what is printed can be read");
  Require(*again == *scenario, "what is printed means the same");
  return 0;
}
