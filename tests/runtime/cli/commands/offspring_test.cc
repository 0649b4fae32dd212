#include "runtime/cli/commands/offspring.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "compiler/compile.h"
#include "compiler/print.h"

namespace plsc {
namespace {

TEST_CASE("Children are one file of several genotypes", "[offspring]") {
  const Program program =
      *Compile(Source("a",
                      "plsc 1\ngenotype a\nalphabet plasticoding 1\n"
                      "rule C -> { C }\n"));
  std::istringstream in;
  std::ostringstream out;
  std::ostringstream err;
  cli::Io io{in, out, err};
  REQUIRE(cli::DeliverChildren({{program, "one", "{}"}, {program, "two", "{}"}},
                               {"", cli::OutputKind::kGenotype}, io));
  const auto all = CompileAll(Source("all", out.str()));
  REQUIRE(all);
  REQUIRE(all->size() == 2);
  CHECK((*all)[1].genotype.name == "a_2");
  CHECK(err.str() == "a_1: one\na_2: two\n");

  out.str("");
  REQUIRE(cli::DeliverChildren({{program, "one", R"({"seed":1})"}},
                               {"", cli::OutputKind::kChildren}, io));
  const auto line = nlohmann::json::parse(out.str());
  CHECK(line["genotype"] == "a");
  CHECK(line["seed"] == 1);
  CHECK(line["text"] == Print(program));
  CHECK_FALSE(cli::DeliverChildren({{program, "one", "{}"}},
                                   {"/no/such/folder/x"}, io));
}

}  // namespace
}  // namespace plsc
