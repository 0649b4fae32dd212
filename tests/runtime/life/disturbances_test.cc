#include "runtime/life/disturbances.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "tests/runtime/life/disturbed.h"

namespace plsc {

using test::Changes;
using test::Everything;

TEST_CASE("The text of a disturbance has all of it", "[disturbances]") {
  CHECK(DisturbanceText({}).empty());
  CHECK(ReadDisturbance("") == Disturbance{});
  CHECK(DisturbanceText(Everything()).ends_with('\n'));
  CHECK(ReadDisturbance(DisturbanceText(Everything())) == Everything());
  std::set<std::string> texts;
  for (const auto& change : Changes()) {
    Disturbance changed;
    change(changed);
    texts.insert(DisturbanceText(changed));
    CHECK(ReadDisturbance(DisturbanceText(changed)) == changed);
  }
  CHECK(texts.size() == Changes().size());
  CHECK(DisturbanceIn({}, 3) == Disturbance{});
  CHECK(DisturbanceIn({{}, Everything()}, 1) == Everything());
}

}  // namespace plsc
