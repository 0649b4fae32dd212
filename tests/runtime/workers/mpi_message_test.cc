#include "runtime/workers/mpi_message.h"

#include <catch2/catch.hpp>

namespace plsc {

TEST_CASE("What ranks tell each other arrives as it was", "[mpi]") {
  for (const RankWords& words :
       {RankWords{RankWord::kHello, 3, "plsc"},
        RankWords{RankWord::kEnd, 0, ""},
        RankWords{RankWord::kWork, 2'000'000'000, std::string("a\0b\n", 4)},
        RankWords{RankWord::kAnswer, -1, std::string(100'000, '\xff')}}) {
    CHECK(Decode(Encode(words)) == words);
  }
}

TEST_CASE("The version that ranks compare names all that results depend on",
          "[mpi]") {
  CHECK_THAT(ProgramVersion(), Catch::Contains("plsc 0.") &&
                                   Catch::Contains("ODE 0.") &&
                                   Catch::Contains("g++ "));
}

}  // namespace plsc
