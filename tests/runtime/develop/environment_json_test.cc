#include "runtime/develop/environment_json.h"

#include <catch2/catch.hpp>

namespace plsc {

namespace {

const std::vector<State>& SomeStates() {
  static const std::vector<State> states = {
      {"inclined", StateType::kBool, 0, 0, {}},
      {"heat", StateType::kReal, -40, 60, {}},
      {"ground", StateType::kEnum, 0, 0, {"dry", "wet"}}};
  return states;
}

}  // namespace

TEST_CASE("What is sensed has the type of its state", "[environment_json]") {
  CHECK(EnvironmentJson({{0, 30.5, 1}}, SomeStates()).dump() ==
        R"({"inclined":false,"heat":30.5,"ground":"wet"})");
  const std::map<std::string, std::string> senses = {
      {"ground", "dry"}, {"heat", "-1e-3"}, {"inclined", "False"}};
  CHECK(SensesJson(senses, SomeStates()).dump() ==
        R"({"ground":"dry","heat":-0.001,"inclined":false})");
  CHECK(SensedValueJson("inclined", "True", SomeStates()) == true);
  // What no state has stays as it is written.
  CHECK(SensedValueJson("other", "True", SomeStates()) == "True");
  CHECK(SensedValueJson("heat", "warm", SomeStates()) == "warm");
}

}  // namespace plsc
