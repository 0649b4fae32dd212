#include "runtime/authors/symbols.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <string>

#include "compiler/limits.h"
#include "grammar/number.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

namespace p = plasticoding;

// plasticoding.py:23-53 at the paper's commit. AJ1 turns about a horizontal
// axis, which is the paper's A2.
constexpr std::array<AuthorsSymbol, 20> kSymbols = {{
    {p::kC, "C", "CORE_COMPONENT"},
    {p::kA2, "AJ1", "JOINT_HORIZONTAL"},
    {p::kA1, "AJ2", "JOINT_VERTICAL"},
    {p::kB, "B", "BLOCK"},
    {p::kT, "ST", "SENSOR"},
    {p::kAddRight, "addr", "ADD_RIGHT"},
    {p::kAddFront, "addf", "ADD_FRONT"},
    {p::kAddLeft, "addl", "ADD_LEFT"},
    {p::kMoveRight, "mover", "MOVE_RIGHT"},
    {p::kMoveFront, "movef", "MOVE_FRONT"},
    {p::kMoveLeft, "movel", "MOVE_LEFT"},
    {p::kMoveBack, "moveb", "MOVE_BACK"},
    {p::kMoveRefI, "brainmoveFTS", "MOVE_REF_S"},
    {p::kMoveRefN, "brainmoveTTS", "MOVE_REF_O"},
    {p::kAddEdge, "brainedge", "ADD_EDGE"},
    {p::kMutateEdge, "brainperturb", "MUTATE_EDGE"},
    {p::kLoop, "brainloop", "LOOP"},
    {p::kMutateAmp, "brainampperturb", "MUTATE_AMP"},
    {p::kMutatePer, "brainperperturb", "MUTATE_PER"},
    {p::kMutateOff, "brainoffperturb", "MUTATE_OFF"},
}};

// Of a joint: which of the authors' parameters (weight, period, phase,
// amplitude) is ours in the order w, a, p, o.
constexpr std::array<std::size_t, 4> kJointOrder = {0, 3, 1, 2};

bool IsJoint(SymbolId symbol) {
  return symbol == p::kA1 || symbol == p::kA2;
}

std::size_t TheirPlace(SymbolId symbol, std::size_t ours) {
  return IsJoint(symbol) ? kJointOrder[ours] : ours;
}

std::string ParametersText(const SymbolInfo& info, SymbolId symbol) {
  if (info.parameters.empty()) return "no parameter";
  if (IsJoint(symbol)) return "4 parameters (weight, period, phase, amplitude)";
  return fmt::format("{} parameter{}", info.parameters.size(),
                     info.parameters.size() == 1 ? "" : "s");
}

Diagnostic UnknownToken(const AuthorsWord& word) {
  Diagnostic diagnostic(
      Code::kUnknownSymbol, word.span,
      fmt::format("a token of Revolve is expected, not '{}'", word.token));
  std::vector<std::string_view> tokens;
  tokens.reserve(kSymbols.size());
  for (const AuthorsSymbol& symbol : kSymbols) tokens.push_back(symbol.token);
  if (const auto near = Suggest(word.token, tokens))
    diagnostic.help = fmt::format("did you mean '{}'?", *near);
  else
    diagnostic.WithNote(
        fmt::format("its tokens are {}", fmt::join(tokens, ", ")));
  return diagnostic;
}

// What is wrong with a parameter, if anything.
std::optional<Diagnostic> CheckNumber(const WrittenNumber& number,
                                      const Parameter& parameter,
                                      bool allow_range) {
  const bool is_whole = std::floor(number.value) == number.value &&
                        std::abs(number.value) <= kMaxWholeNumber;
  if (parameter.is_integer && !is_whole)
    return Diagnostic(Code::kNotWhole, number.span,
                      fmt::format("{} wants a whole number, not {}",
                                  parameter.name, PrintNumber(number.value)));
  if (number.value >= parameter.low && number.value <= parameter.high)
    return std::nullopt;
  Diagnostic diagnostic(
      Code::kArgumentRange, number.span,
      std::isinf(parameter.high)
          ? fmt::format("{} is expected to be {} or more, not {}",
                        parameter.name, PrintNumber(parameter.low),
                        PrintNumber(number.value))
          : fmt::format("{} is expected within {}..{}, not {}", parameter.name,
                        PrintNumber(parameter.low), PrintNumber(parameter.high),
                        PrintNumber(number.value)));
  diagnostic.help =
      "with --allow-range it is imported as it is; plsc then wants that "
      "option to read it";
  if (allow_range) diagnostic.severity = Severity::kWarning;
  return diagnostic;
}

}  // namespace

const AuthorsSymbol* FindAuthorsSymbol(std::string_view token) {
  const auto found =
      std::find_if(kSymbols.begin(), kSymbols.end(),
                   [&](const AuthorsSymbol& s) { return s.token == token; });
  return found == kSymbols.end() ? nullptr : &*found;
}

const AuthorsSymbol& AuthorsSymbolOf(SymbolId symbol) {
  const auto found =
      std::find_if(kSymbols.begin(), kSymbols.end(),
                   [&](const AuthorsSymbol& s) { return s.id == symbol; });
  assert(found != kSymbols.end());
  return *found;
}

const std::vector<SymbolId>& AuthorsLetters() {
  static const std::vector<SymbolId> letters = {p::kC, p::kA2, p::kA1, p::kB,
                                                p::kT};
  return letters;
}

std::optional<Symbol> ImportSymbol(const AuthorsWord& word, bool allow_range,
                                   Reporter* reporter) {
  const AuthorsSymbol* known = FindAuthorsSymbol(word.token);
  if (known == nullptr) {
    reporter->Add(UnknownToken(word));
    return std::nullopt;
  }
  const SymbolInfo& info = (*PlasticodingAlphabet())[known->id];
  if (word.parameters.size() != info.parameters.size()) {
    reporter->Report(
        Code::kArgumentCount, word.span,
        fmt::format("'{}' wants {}, not {}", word.token,
                    ParametersText(info, known->id), word.parameters.size()));
    return std::nullopt;
  }
  Symbol symbol{known->id, {}};
  bool is_right = true;
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const WrittenNumber& number = word.parameters[TheirPlace(known->id, i)];
    symbol.arguments[i] = number.value;
    const auto problem = CheckNumber(number, info.parameters[i], allow_range);
    if (!problem) continue;
    reporter->Add(*problem);
    is_right = is_right && problem->severity == Severity::kWarning;
  }
  if (!is_right) return std::nullopt;
  return symbol;
}

std::vector<double> AuthorsParameters(const Symbol& symbol) {
  const std::size_t count =
      (*PlasticodingAlphabet())[symbol.id].parameters.size();
  std::vector<double> theirs(count);
  for (std::size_t i = 0; i < count; ++i)
    theirs[TheirPlace(symbol.id, i)] = symbol.arguments[i];
  return theirs;
}

}  // namespace plsc
