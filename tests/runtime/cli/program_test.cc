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

TEST_CASE("a program is loaded with its text and its places", "[program]") {
  std::istringstream in(test::kPlasticText);
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  const auto loaded = cli::LoadWithMap("-", false, io);
  REQUIRE(loaded);
  CHECK(loaded->source.name() == "<stdin>");
  CHECK(loaded->mapped.program == test::CompileText(test::kPlasticText));
  REQUIRE(loaded->mapped.map.rules.size() == 2);
  CHECK(loaded->source.text()[loaded->mapped.map.rules[0].head.begin] == 'C');
  CHECK_FALSE(cli::LoadWithMap("/none.pls", false, io));
  CHECK(err.str().find("P5014") != std::string::npos);
}

}  // namespace
}  // namespace plsc
