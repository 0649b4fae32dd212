#pragma once

// Reads a symbol string into both turtles: which symbol goes to which turtle
// with which arguments. Develop and the trace share it, so that they cannot
// differ.

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "runtime/develop/body_turtle.h"
#include "runtime/develop/brain_turtle.h"
#include "runtime/develop/regulate.h"
#include "sim/phenotype.h"

namespace plsc {

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
  /// Which parameter of the neuron a mutate_ command changes.
  static double Node::*ParameterOf(SymbolId symbol) {
    if (symbol == plasticoding::kMutateAmp) return &Node::amplitude;
    if (symbol == plasticoding::kMutatePer) return &Node::period;
    return &Node::phase_offset;
  }

 private:
  Effect Mount(SymbolId symbol, const Arguments& arguments);
  // Numbers beyond a node's edges mean its last edge, so a bound far above any
  // number of edges changes nothing and keeps the conversion defined.
  static int EdgeNumber(double argument) {
    return static_cast<int>(std::clamp(argument, 1.0, 1e9));
  }
  // The side of a mounting or moving command; the table of symbols has them in
  // one row.
  static Slot SideOf(SymbolId symbol) {
    static constexpr std::array<Slot, 7> kSides{
        Slot::kRight, Slot::kFront, Slot::kLeft,                 // add_
        Slot::kBack,  Slot::kRight, Slot::kFront, Slot::kLeft};  // move_
    return kSides[static_cast<std::size_t>(symbol) -
                  static_cast<std::size_t>(plasticoding::kAddRight)];
  }

  BodyTurtle body_;
  BrainTurtle brain_;
};

// One flat switch, and one case for symbols that differ in a side only: what
// comes next in a string is hard to predict, so branches are most of the cost.
inline Effect StringReader::Read(SymbolId symbol, const Arguments& arguments) {
  switch (symbol) {
    case plasticoding::kC:
      return Effect::kStarted;  // unique and first: the turtle starts on it (I)
    case plasticoding::kB:
    case plasticoding::kA1:
    case plasticoding::kA2:
    case plasticoding::kT:
      return Mount(symbol, arguments);
    case plasticoding::kAddRight:
    case plasticoding::kAddFront:
    case plasticoding::kAddLeft:
      body_.SetSlot(SideOf(symbol));
      return Effect::kSlotUsed;
    case plasticoding::kMoveBack:
    case plasticoding::kMoveRight:
    case plasticoding::kMoveFront:
    case plasticoding::kMoveLeft:
      return body_.Move(SideOf(symbol));
    case plasticoding::kMoveRefI:
      return brain_.MoveInputReference(EdgeNumber(arguments[0]),
                                       EdgeNumber(arguments[1]));
    case plasticoding::kMoveRefN:
      return brain_.MoveNeuronReference(EdgeNumber(arguments[0]),
                                        EdgeNumber(arguments[1]));
    case plasticoding::kAddEdge:
      return brain_.AddEdge(arguments[0]);
    case plasticoding::kLoop:
      return brain_.AddLoop(arguments[0]);
    case plasticoding::kMutateEdge:
      return brain_.MutateEdge(arguments[0]);
    case plasticoding::kMutateAmp:
    case plasticoding::kMutatePer:
    case plasticoding::kMutateOff:
      return brain_.MutateParameter(ParameterOf(symbol), arguments[0]);
  }
  assert(false);
  return Effect::kStarted;
}

}  // namespace plsc
