#include "compiler/print_alphabet.h"

#include <cmath>

#include "compiler/print.h"

namespace plsc {

namespace {

std::string PrintBound(const Parameter& parameter, double bound) {
  if (!parameter.is_integer || bound == 0) return PrintNumber(bound);
  return std::to_string(static_cast<long long>(bound));
}

std::string PrintParameter(const Parameter& parameter) {
  std::string text = parameter.name;
  text += parameter.is_integer ? ": int" : ": real";
  if (std::isfinite(parameter.low))
    text += " in " + PrintBound(parameter, parameter.low) + ".." +
            PrintBound(parameter, parameter.high);
  return text;
}

std::string PrintDeclaration(const SymbolInfo& symbol) {
  std::string text = symbol.name;
  for (std::size_t i = 0; i < symbol.parameters.size(); ++i) {
    text += i == 0 ? "(" : ", ";
    text += PrintParameter(symbol.parameters[i]);
  }
  if (!symbol.parameters.empty()) text += ")";
  return text;
}

}  // namespace

std::string PrintAlphabet(const Alphabet& alphabet) {
  std::string text = "alphabet " + alphabet.name();
  if (alphabet.is_built_in())
    return text + " " + std::to_string(alphabet.version()) + "\n";
  text += " {";
  const std::vector<SymbolInfo>& symbols = alphabet.symbols();
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    // The order of symbols is their numbering, so groups may alternate.
    const bool is_new_group =
        i == 0 || symbols[i].is_replaceable != symbols[i - 1].is_replaceable;
    if (is_new_group) {
      text += i == 0 ? "\n  " : ";\n  ";
      text += symbols[i].is_replaceable ? "replaceable " : "terminal ";
    } else {
      text += ", ";
    }
    text += PrintDeclaration(symbols[i]);
  }
  return text + "\n}\n";
}

}  // namespace plsc
