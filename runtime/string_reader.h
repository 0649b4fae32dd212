#pragma once

// Reads a symbol string into both turtles: which symbol goes to which turtle
// with which arguments. Develop and the trace share it, so that they cannot
// differ.

#include <array>
#include <utility>

#include "runtime/body_turtle.h"
#include "runtime/brain_turtle.h"
#include "runtime/regulate.h"
#include "sim/phenotype.h"

namespace plsc {

using Arguments = std::array<double, kMaxParameters>;

class StringReader {
 public:
  explicit StringReader(const DevelopmentSettings& settings)
      : body_(settings.max_modules, settings.move_to_new) {}

  /// What the symbol does. Whether the slot-reference that a mounting command
  /// sets is ever used is not known yet: its effect is kSlotUsed.
  Effect Read(SymbolId symbol, const Arguments& arguments);
  Phenotype Take() && {
    return {std::move(body_).TakeBody(), std::move(brain_).TakeBrain()};
  }

  const BodyTurtle& body() const { return body_; }
  const BrainTurtle& brain() const { return brain_; }

 private:
  Effect MountJoint(ModuleType type, const Arguments& arguments);
  Effect MountSensor(double weight);

  BodyTurtle body_;
  BrainTurtle brain_;
};

/// The arguments of the symbol that the occurrence names; the axiom has none.
inline const Arguments& ArgumentsOf(const Genotype& genotype,
                                    const Occurrence& occurrence) {
  static constexpr Arguments kNone{};
  return occurrence.rule == kNoRule ? kNone
                                    : genotype.rules[occurrence.rule]
                                          .production[occurrence.position]
                                          .arguments;
}

}  // namespace plsc
