#include "runtime/store/engine.h"

#include <catch2/catch.hpp>

#include "sim/machine_kind.h"

namespace plsc {

TEST_CASE("An engine is its objects and the kind of the machine", "[engine]") {
  const std::string_view id = EngineId();
  CHECK(id.size() == 32);
  CHECK(id.find_first_not_of("0123456789abcdef") == std::string_view::npos);
  CHECK(ThisEngine() == std::string(id) + " " + MachineKind());
  CHECK(ThisEngine(false) == std::string(id) + " any");
}

}  // namespace plsc
