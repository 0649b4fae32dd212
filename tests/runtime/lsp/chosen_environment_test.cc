#include "runtime/lsp/chosen_environment.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("An environment is chosen by its name or its values", "[lsp]") {
  Analysis analysis(kTestUri, std::string(kGecko));
  const Section& section = analysis.sections()[0];
  REQUIRE(EnvironmentsOf(section).size() == 2);
  CHECK(ChosenFor(section, "")->name == "flat");
  CHECK(ChosenFor(section, "tilted")->environment.values ==
        std::vector<double>{1, 12.5, 1});
  CHECK(ChosenFor(section, "inclined=True, warmth=-1,ground=dry")
            ->environment.values == std::vector<double>{1, -1, 0});
  CHECK_FALSE(ChosenFor(section, "elsewhere"));
  CHECK_FALSE(ChosenFor(section, "inclined=True"));
  CHECK_FALSE(ChosenFor(section, "inclined=7,warmth=0,ground=dry"));
}

TEST_CASE("Without environments nothing is chosen", "[lsp]") {
  Analysis analysis(kTestUri, "plsc 1\nalphabet plasticoding 1\n");
  CHECK_FALSE(ChosenFor(analysis.sections()[0], ""));
}

TEST_CASE("Incomplete environments cannot be chosen", "[lsp]") {
  Analysis analysis(kTestUri,
                    "plsc 1\nsense a: bool\nsense b: bool\n"
                    "environment half { a = True }\n"
                    "environment whole { a = True, b = False }\n");
  const auto known = EnvironmentsOf(analysis.sections()[0]);
  REQUIRE(known.size() == 1);
  CHECK(known[0].name == "whole");
}

}  // namespace plsc::lsp
