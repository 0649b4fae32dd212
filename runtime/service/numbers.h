#pragma once

// The numbers that a text has for people to turn: arguments of the rules'
// symbols, thresholds of clauses, settings, constants, and what environments
// have for states that are real. Also of broken texts, as far as they could be
// read.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grammar/source.h"
#include "runtime/lsp/analysis.h"

namespace plsc::service {

struct TurnableNumber {
  Span span;    ///< of its digits
  Span around;  ///< of the symbol, term or item that it belongs to
  std::string
      kind;  ///< "argument", "threshold", "setting", "constant", "sensed"
  std::string name;   ///< "a of A1", "heat", "iterations"
  std::string about;  ///< Markdown, as a hover has it
  double value = 0;
  bool is_whole = false;  ///< must be written without '.' and exponent
  double lowest = 0;      ///< -infinity: no bound
  double highest = 0;
};

/// By position.
std::vector<TurnableNumber> NumbersOf(lsp::Analysis& analysis);

/// The one that `offset` touches, or the nearest of what is around it; of the
/// name of a constant, the constant's. Nothing when there is none.
std::optional<TurnableNumber> NumberAt(
    lsp::Analysis& analysis, const std::vector<TurnableNumber>& numbers,
    std::uint32_t offset);

/// What a slider goes through: finite also where there is no bound, and the
/// step between its values.
struct SliderRange {
  double from = 0;
  double to = 0;
  double step = 0;
};
SliderRange SliderOf(const TurnableNumber& number);

}  // namespace plsc::service
