#include "runtime/cli/files/load_program.h"

#include <catch2/catch.hpp>
#include <cctype>
#include <set>
#include <sstream>

#include "tests/runtime/cli/run_plsc.h"
#include "tests/runtime/develop/compile_text.h"

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

TEST_CASE("FILE#NAME warns of that genotype and of what all share",
          "[program]") {
  const test::TemporaryFolder folder;
  std::string text = "plsc 1\nalphabet plasticoding 1\nrule T -> { T(1.5) }\n";
  for (int i = 0; i < 20; ++i)
    text += "genotype g" + std::to_string(i) + "\nrule C -> { C add_left T(1." +
            std::to_string(10 + i) + ") }\n";
  const std::string path = folder.Write("all.pls", text);
  const auto other = folder.Write("other.pls", text);
  const std::vector<std::vector<std::string>> commands = {
      {"develop", path + "#g7"},
      {"regulate", path + "#g7"},
      {"why", path + "#g7", "--module", "1"},
      {"draw", path + "#g7", "-o", folder / "a.svg"},
      {"export", path + "#g7", "--to", "urdf", "-o", folder / "a.urdf"},
      {"mutate", path + "#g7", "--seed", "1"},
      {"hash", path + "#g7"},
      {"stats", path + "#g7"},
      {"trim", path + "#g7", "--check"},
      {"diff", path + "#g7", other + "#g7"},
      {"cross", path + "#g7", other + "#g7", "--seed", "1"}};
  for (auto command : commands) {
    CAPTURE(command);
    command.emplace_back("--allow-range");
    const auto ran = test::RunPlsc(command);
    CHECK(ran.exit != 2);
    std::set<std::string> places;
    for (std::size_t at = ran.err.find(".pls:"); at != std::string::npos;
         at = ran.err.find(".pls:", at + 1))
      if (std::isdigit(static_cast<unsigned char>(ran.err[at + 5])) != 0)
        places.insert(
            ran.err.substr(at + 5, ran.err.find(':', at + 5) - at - 5));
    // The shared rule in line 3, and the genotype's own in line 19.
    for (const std::string& line : places) CHECK((line == "3" || line == "19"));
    if (command[0] == "develop" || command[0] == "mutate")
      CHECK(places == std::set<std::string>{"3", "19"});
  }
  // Without a name the file is meant, with all its warnings.
  const auto all = test::RunPlsc({"stats", path, "--allow-range"});
  CHECK(all.err.find(".pls:5:") != std::string::npos);
}

TEST_CASE("FILE#NAME chooses a genotype of a file", "[program]") {
  const test::TemporaryFolder folder;
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\n"
      "genotype snake\nrule C -> { C add_front B }\n"
      "genotype gecko\nrule C -> { C add_left B }\n";
  const std::string path = folder.Write("zoo.pls", text);
  const auto run = [&](const std::string& file) {
    return test::RunPlsc({"develop", file, "--format", "json"});
  };
  CHECK(run(path + "#gecko").out.find("add_left") != std::string::npos);
  CHECK(run(path + "#snake").out.find("add_front") != std::string::npos);
  CHECK(run(path).exit == 1);
  CHECK(run(path).err.find("as in '" + path + "#gecko'") != std::string::npos);
  CHECK(run(path + "#geko").err.find("did you mean 'gecko'?") !=
        std::string::npos);
  CHECK(run(path + "#lizard").err.find("it holds snake, gecko") !=
        std::string::npos);
  // A file of that very name goes first.
  const std::string odd = folder.Write("zoo.pls#gecko", text);
  CHECK(run(odd).exit == 1);
}

TEST_CASE("A place in the text chooses the genotype", "[program]") {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.Write("zoo.pls",
                   "plsc 1\nalphabet plasticoding 1\n"
                   "rule B -> { B T(0.5) }\n"
                   "genotype snake\nrule C -> { C add_front B }\n"
                   "genotype gecko\nrule C -> { C add_left B }\n");
  const auto own = test::RunPlsc({"why", path + ":7:15"});
  CHECK(own.exit == 0);
  CHECK(own.out.find("gecko in any") != std::string::npos);
  // What both share is asked of one of them.
  CHECK(test::RunPlsc({"why", path + ":3:15"}).exit == 1);
  CHECK(test::RunPlsc({"why", path + "#snake:3:15"}).exit == 0);
}

}  // namespace
}  // namespace plsc
