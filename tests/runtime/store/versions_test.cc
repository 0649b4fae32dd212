#include "runtime/store/versions.h"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace plsc {
namespace {

TEST_CASE("What another program began is told by what differs", "[versions]") {
  const Versions own = ThisProgram();
  CHECK(CheckVersions("run", own) == std::nullopt);
  struct Row {
    std::string Versions::*field;
    std::string what;
  };
  const std::vector<Row> rows = {{&Versions::plsc, "plsc"},
                                 {&Versions::ode, "ODE"},
                                 {&Versions::compiler, "compiler"},
                                 {&Versions::machine, "machine"}};
  for (const Row& row : rows) {
    INFO(row.what);
    Versions other = own;
    other.*row.field = "abacus";
    const auto failure = CheckVersions("run", other);
    REQUIRE(failure);
    CHECK(failure->text.find("'run' was begun with " + row.what + " abacus") ==
          0);
  }
}

}  // namespace
}  // namespace plsc
