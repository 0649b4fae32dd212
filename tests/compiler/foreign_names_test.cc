#include "compiler/foreign_names.h"

#include <catch2/catch.hpp>

#include "compiler/alphabet.h"

namespace plsc {
namespace {

TEST_CASE("The authors' joints are crossed over to the paper's names",
          "[foreign_names]") {
  // AJ1's axis is horizontal, which the paper calls A2.
  CHECK(PlasticodingNameFor("AJ1") == "A2");
  CHECK(PlasticodingNameFor("AJ2") == "A1");
  CHECK(PlasticodingNameFor("wheel").empty());
}

TEST_CASE("Every foreign word stands for a symbol of Table 1",
          "[foreign_names]") {
  for (const char* word :
       {"AJ1", "AJ2", "ST", "addr", "addf", "addl", "mover", "movef", "movel",
        "moveb", "brainmoveFTS", "brainmoveTTS", "brainedge", "brainperturb",
        "brainloop", "brainampperturb", "brainperperturb", "brainoffperturb"}) {
    CAPTURE(word);
    CHECK(PlasticodingAlphabet()->Find(PlasticodingNameFor(word)));
    CHECK_FALSE(PlasticodingAlphabet()->Find(word));
    CHECK(ForeignNote(word).find(PlasticodingNameFor(word)) !=
          std::string::npos);
  }
}

}  // namespace
}  // namespace plsc
