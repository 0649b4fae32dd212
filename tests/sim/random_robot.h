#pragma once

// Random robots with moving servos, for benchmarks and for tests that need
// many unlike ones. Drawn from the given generator alone.

#include <random>

#include "sim/assembly.h"
#include "sim/overlap.h"
#include "tests/sim/bodies.h"

namespace plsc {

/// A tree of `size` modules, two joints to a brick, that can be assembled and
/// has at least one joint. Oscillators of amplitude 2 and period 2 s.
inline Phenotype RandomRobot(int size, std::mt19937& random) {
  const auto draw = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  while (true) {
    Body body = LoneCore();
    while (static_cast<int>(body.modules.size()) < size) {
      const int parent = draw(static_cast<int>(body.modules.size()));
      const Module& above = body.modules[static_cast<std::size_t>(parent)];
      const int slot = IsJoint(above.type) ? 1 : draw(kSlots);
      if (above.children[static_cast<std::size_t>(slot)] != kNoModule) continue;
      if (slot == 0 && parent != 0) continue;
      constexpr ModuleType kTypes[] = {ModuleType::kBrick,
                                       ModuleType::kVerticalJoint,
                                       ModuleType::kHorizontalJoint};
      Mount(body, parent, static_cast<Slot>(slot), kTypes[draw(3)]);
    }
    const Assembly assembly = Assemble(body);
    if (!assembly.hinges.empty() && FindOverlaps(assembly).empty())
      return WithOscillators(body, 2, 2);
  }
}

}  // namespace plsc
