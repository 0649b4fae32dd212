#include "runtime/formula/random_formula.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "runtime/formula/quantities.h"
#include "sim/maths/arc.h"
#include "sim/maths/exponential.h"
#include "sim/maths/hypot.h"
#include "sim/maths/sine.h"

namespace plsc::test {
namespace {

using Value = std::optional<double>;
using Values = std::span<const double>;

Value Finite(double value) {
  return std::isfinite(value) ? Value(value) : std::nullopt;
}

std::size_t Draw(std::mt19937& random, std::size_t below) {
  return random() % below;
}

RandomFormula DrawLeaf(std::mt19937& random) {
  if (Draw(random, 2) == 0) {
    const std::size_t i = Draw(random, Quantities().size());
    return {std::string(Quantities()[i].name),
            [i](Values values) { return Finite(values[i]); }};
  }
  // Ends of a kind that decimals have no trouble with.
  const auto number = static_cast<double>(Draw(random, 64)) / 8;
  std::string text = std::to_string(number);
  return {text, [number](Values) { return Value(number); }};
}

RandomFormula DrawTruth(std::mt19937& random, int depth) {
  if (depth > 0 && Draw(random, 3) == 0) {
    const RandomFormula a = DrawTruth(random, depth - 1);
    if (Draw(random, 3) == 0)
      return {"(not " + a.text + ")", [a](Values values) -> Value {
                const Value one = a.value(values);
                if (!one) return std::nullopt;
                return *one == 0 ? 1 : 0;
              }};
    const RandomFormula b = DrawTruth(random, depth - 1);
    const bool is_and = Draw(random, 2) == 0;
    return {"(" + a.text + (is_and ? " and " : " or ") + b.text + ")",
            [a, b, is_and](Values values) -> Value {
              const Value one = a.value(values);
              if (!one || (*one != 0) != is_and) return one;
              return b.value(values);
            }};
  }
  const RandomFormula a = DrawNumber(random, depth - 1);
  const RandomFormula b = DrawNumber(random, depth - 1);
  const char* const signs[] = {"<", "<=", ">", ">=", "==", "!="};
  const std::size_t which = Draw(random, 6);
  return {"(" + a.text + signs[which] + b.text + ")",
          [a, b, which](Values values) -> Value {
            const Value one = a.value(values);
            if (!one) return std::nullopt;
            const Value two = b.value(values);
            if (!two) return std::nullopt;
            const bool holds[] = {*one<*two, *one <= *two, *one> * two,
                                  *one >= *two, *one == *two, *one != *two};
            return holds[which] ? 1 : 0;
          }};
}

struct Function {
  const char* name;
  std::size_t count;
  double (*of)(const std::vector<double>&);
};

const Function kFunctions[] = {
    {"abs", 1, [](const auto& x) { return x[0] < 0 ? -x[0] : x[0]; }},
    {"sqrt", 1, [](const auto& x) { return std::sqrt(x[0]); }},
    {"exp", 1, [](const auto& x) { return Exp(x[0]); }},
    {"log", 1, [](const auto& x) { return Log(x[0]); }},
    {"sin", 1, [](const auto& x) { return Sin(x[0]); }},
    {"cos", 1, [](const auto& x) { return Cos(x[0]); }},
    {"atan2", 2, [](const auto& x) { return Atan2(x[0], x[1]); }},
    {"hypot", 2, [](const auto& x) { return Hypot(x[0], x[1]); }},
    {"min", 3,
     [](const auto& x) {
       return std::min({x[0], x[1], x[2]});
     }},
    {"max", 2, [](const auto& x) { return x[0] < x[1] ? x[1] : x[0]; }},
    {"clamp", 3,
     [](const auto& x) {
       const double raised = x[0] < x[1] ? x[1] : x[0];
       return raised > x[2] ? x[2] : raised;
     }},
};

RandomFormula DrawCall(std::mt19937& random, int depth) {
  const Function& function = kFunctions[Draw(random, std::size(kFunctions))];
  std::vector<RandomFormula> arguments;
  std::string text = function.name;
  for (std::size_t i = 0; i < function.count; ++i) {
    arguments.push_back(DrawNumber(random, depth - 1));
    text += (i == 0 ? "(" : ", ") + arguments.back().text;
  }
  return {text + ")", [arguments, &function](Values values) -> Value {
            std::vector<double> known;
            for (const RandomFormula& argument : arguments) {
              const Value one = argument.value(values);
              if (!one) return std::nullopt;
              known.push_back(*one);
            }
            return Finite(function.of(known));
          }};
}

RandomFormula DrawOperation(std::mt19937& random, int depth) {
  const RandomFormula a = DrawNumber(random, depth - 1);
  const RandomFormula b = DrawNumber(random, depth - 1);
  const char sign = "+-*/"[Draw(random, 4)];
  return {"(" + a.text + " " + sign + " " + b.text + ")",
          [a, b, sign](Values values) -> Value {
            const Value one = a.value(values);
            if (!one) return std::nullopt;
            const Value two = b.value(values);
            if (!two) return std::nullopt;
            return Finite(sign == '+'   ? *one + *two
                          : sign == '-' ? *one - *two
                          : sign == '*' ? *one * *two
                                        : *one / *two);
          }};
}

}  // namespace

RandomFormula DrawNumber(std::mt19937& random, int depth) {
  if (depth <= 0) return DrawLeaf(random);
  switch (Draw(random, 6)) {
    case 0:
      return DrawLeaf(random);
    case 1:
      return DrawCall(random, depth);
    case 2: {
      const RandomFormula a = DrawNumber(random, depth - 1);
      return {"-" + a.text, [a](Values values) -> Value {
                const Value one = a.value(values);
                return one ? Value(-*one) : std::nullopt;
              }};
    }
    case 3: {
      const RandomFormula when = DrawTruth(random, depth - 1);
      const RandomFormula a = DrawNumber(random, depth - 1);
      const RandomFormula b = DrawNumber(random, depth - 1);
      return {"(" + when.text + " ? " + a.text + " : " + b.text + ")",
              [when, a, b](Values values) -> Value {
                const Value one = when.value(values);
                if (!one) return std::nullopt;
                return *one != 0 ? a.value(values) : b.value(values);
              }};
    }
    default:
      return DrawOperation(random, depth);
  }
}

}  // namespace plsc::test
