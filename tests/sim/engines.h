#pragma once

// Tests that every engine has to pass.

#include <catch2/catch.hpp>
#include <string>

#include "sim/options.h"

namespace plsc::test {

/// Has the test case that calls it run once with each engine.
inline EngineKind EachEngine() {
  return GENERATE(EngineKind::kOde, EngineKind::kArticulated);
}

inline SimulationOptions With(EngineKind engine,
                              SimulationOptions options = {}) {
  options.physics.engine = engine;
  return options;
}

/// Bounds that differ.
template <typename Value>
Value Of(EngineKind engine, const Value& of_ode, const Value& of_articulated) {
  return engine == EngineKind::kOde ? of_ode : of_articulated;
}

}  // namespace plsc::test

template <>
struct Catch::StringMaker<plsc::EngineKind> {
  static std::string convert(plsc::EngineKind engine) {
    return engine == plsc::EngineKind::kOde ? "ode" : "articulated";
  }
};
