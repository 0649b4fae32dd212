#include "runtime/cli/program.h"

#include <catch2/catch.hpp>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/compile_text.h"

namespace plsc {
namespace {

std::vector<std::string> Chosen(const std::string& text,
                                const std::vector<std::string>& wanted) {
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const auto chosen =
      cli::ChooseEnvironments(test::CompileText(text), wanted, io);
  if (!chosen) return {"none"};
  std::vector<std::string> names;
  for (const NamedEnvironment& named : *chosen) names.push_back(named.name);
  return names;
}

TEST_CASE("environments are chosen by name, by value, or all", "[program]") {
  using Names = std::vector<std::string>;
  const std::string text = test::kPlasticText;
  CHECK(Chosen(text, {}) == Names{"flat", "tilted"});
  CHECK(Chosen(text, {"tilted"}) == Names{"tilted"});
  CHECK(Chosen(text, {"inclined=True", "flat"}) ==
        Names{"inclined=True", "flat"});
  CHECK(Chosen(text, {"steep"}) == Names{"none"});
  const std::string baseline =
      "plsc 1\ngenotype b\nalphabet plasticoding 1\nrule C -> { C }\n";
  CHECK(Chosen(baseline, {}) == Names{"any"});
}

}  // namespace
}  // namespace plsc
