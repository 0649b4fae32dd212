#include "compiler/alphabet.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <functional>
#include <utility>

namespace plsc {

namespace {

Parameter Weight(std::string name, std::string doc) {
  return {std::move(name),          false,
          plasticoding::kWeightLow, plasticoding::kWeightHigh,
          Sampling::kUniform,       std::move(doc)};
}

Parameter Oscillator(std::string name, std::string doc) {
  return {std::move(name),
          false,
          plasticoding::kOscillatorLow,
          plasticoding::kOscillatorHigh,
          Sampling::kUniform,
          std::move(doc)};
}

Parameter Amount(std::string name, std::string doc) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.sampling = Sampling::kNormal;
  parameter.doc = std::move(doc);
  return parameter;
}

Parameter Edge(std::string name, std::string doc) {
  Parameter parameter;
  parameter.name = std::move(name);
  parameter.is_integer = true;
  parameter.low = 1;
  parameter.sampling = Sampling::kCeilAbsNormal;
  parameter.doc = std::move(doc);
  return parameter;
}

std::vector<Parameter> JointParameters() {
  return {Weight("w", "weight of the neuron's edges"),
          Oscillator("a", "amplitude of the oscillation"),
          Oscillator("p", "period of the oscillation, s"),
          Oscillator("o", "phase offset, in periods")};
}

std::vector<Parameter> EdgeSteps() {
  return {Edge("t", "edge to the temporary node, counted from 1"),
          Edge("d", "edge to the definite node, counted from 1")};
}

SymbolInfo Module(std::string name, std::vector<Parameter> parameters,
                  std::string doc) {
  return {std::move(name), Category::kModule, true, std::move(parameters),
          std::move(doc)};
}

SymbolInfo Command(Category category, std::string name,
                   std::vector<Parameter> parameters, std::string doc) {
  return {std::move(name), category, false, std::move(parameters),
          std::move(doc)};
}

// In the order of Table 1; SymbolId values in plasticoding:: follow it.
std::vector<SymbolInfo> TableOne() {
  using enum Category;
  return {
      Module("C", {}, "core component, the axiom"),
      Module("B", {}, "brick"),
      Module("A1", JointParameters(), "vertical joint (its axis is vertical)"),
      Module("A2", JointParameters(),
             "horizontal joint (its axis is horizontal)"),
      Module("T", {Weight("w", "weight of the input's edges")}, "touch sensor"),
      Command(kMounting, "add_right", {},
              "the next module goes to the right of the module-reference"),
      Command(kMounting, "add_front", {},
              "the next module goes to the front of the module-reference"),
      Command(kMounting, "add_left", {},
              "the next module goes to the left of the module-reference"),
      Command(kMoving, "move_back", {},
              "module-reference to the module that it came from"),
      Command(kMoving, "move_right", {},
              "module-reference to the module at its right"),
      Command(kMoving, "move_front", {},
              "module-reference to the module at its front"),
      Command(kMoving, "move_left", {},
              "module-reference to the module at its left"),
      Command(kControllerMoving, "move_ref_I", EdgeSteps(),
              "input-reference to input d of neuron t of the "
              "input-reference"),
      Command(kControllerMoving, "move_ref_N", EdgeSteps(),
              "neuron-reference to neuron d of input t of the "
              "neuron-reference"),
      Command(kControllerChanging, "add_edge",
              {Weight("w", "weight of the edge")},
              "edge from the input-reference to the neuron-reference"),
      Command(kControllerChanging, "loop", {Weight("w", "weight of the edge")},
              "recurrent edge on the neuron-reference"),
      Command(kControllerChanging, "mutate_edge",
              {Amount("w", "added to the weight")},
              "changes the edge between input- and neuron-reference"),
      Command(kControllerChanging, "mutate_amp",
              {Amount("m", "added to the amplitude")},
              "changes the amplitude of the neuron-reference"),
      Command(kControllerChanging, "mutate_per",
              {Amount("m", "added to the period, s")},
              "changes the period of the neuron-reference"),
      Command(kControllerChanging, "mutate_off",
              {Amount("m", "added to the phase offset")},
              "changes the phase offset of the neuron-reference"),
  };
}

bool SameParameter(const Parameter& a, const Parameter& b) {
  return a.name == b.name && a.is_integer == b.is_integer && a.low == b.low &&
         a.high == b.high && a.sampling == b.sampling;
}

// Documentation is not part of what a symbol is.
bool SameSymbol(const SymbolInfo& a, const SymbolInfo& b) {
  return a.name == b.name && a.category == b.category &&
         a.is_replaceable == b.is_replaceable &&
         std::equal(a.parameters.begin(), a.parameters.end(),
                    b.parameters.begin(), b.parameters.end(), SameParameter);
}

// Of a hash table with open addressing; `slots` is a power of two.
std::size_t FirstSlot(std::string_view name, std::size_t slots) {
  if (name.empty()) return 0;
  // Four bytes and no loop: std::hash took as long as the rest of Find. They
  // tell the names of plasticoding apart; equal ones cost a comparison more.
  const auto byte = [&](std::size_t i) -> std::size_t {
    return static_cast<unsigned char>(name[i]);
  };
  const std::size_t size = name.size();
  const std::size_t mixed = byte(0) + 7 * byte(size / 2) + 31 * byte(size - 1) +
                            127 * byte(size / 3) + size;
  return mixed & (slots - 1);
}

}  // namespace

Alphabet::Alphabet(std::string name, int version,
                   std::vector<SymbolInfo> symbols)
    : name_(std::move(name)), version_(version), symbols_(std::move(symbols)) {
  // A quarter full at most: nearly every name is found at its first slot, and
  // there is always an empty one to stop at.
  slots_.resize(std::bit_ceil(4 * symbols_.size() + 1));
  for (std::uint32_t i = 0; i < symbols_.size(); ++i) {
    assert(symbols_[i].parameters.size() <= kMaxParameters);
    std::size_t slot = FirstSlot(symbols_[i].name, slots_.size());
    while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
    slots_[slot] = i + 1;
  }
}

std::optional<SymbolId> Alphabet::Find(std::string_view name) const {
  std::size_t slot = FirstSlot(name, slots_.size());
  for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1))
    if (symbols_[slots_[slot] - 1].name == name)
      return static_cast<SymbolId>(slots_[slot] - 1);
  return std::nullopt;
}

std::vector<SymbolId> Alphabet::OfCategory(Category category) const {
  std::vector<SymbolId> ids;
  for (std::size_t i = 0; i < symbols_.size(); ++i)
    if (symbols_[i].category == category)
      ids.push_back(static_cast<SymbolId>(i));
  return ids;
}

bool operator==(const Alphabet& a, const Alphabet& b) {
  return a.name_ == b.name_ && a.version_ == b.version_ &&
         std::equal(a.symbols_.begin(), a.symbols_.end(), b.symbols_.begin(),
                    b.symbols_.end(), SameSymbol);
}

const AlphabetPtr& PlasticodingAlphabet() {
  static const AlphabetPtr alphabet =
      std::make_shared<const Alphabet>("plasticoding", 1, TableOne());
  return alphabet;
}

}  // namespace plsc
