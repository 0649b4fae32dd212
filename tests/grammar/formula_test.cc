// Shapes are compared as text in which every part has its parentheses, written
// here by another walk than the product's printer.

#include "grammar/formula.h"

#include <catch2/catch.hpp>
#include <string>

namespace plsc {
namespace {

std::string Shape(const FormulaTree& tree, std::size_t index) {
  const FormulaPart& part = tree.parts[index];
  const auto operand = [&](std::size_t i) {
    return Shape(tree, part.operands[i]);
  };
  const auto two = [&](const char* sign) {
    return "(" + operand(0) + sign + operand(1) + ")";
  };
  using Part = FormulaPart::Kind;
  switch (part.kind) {
    case Part::kNumber:
    case Part::kTruth:
      return std::string(tree.Text(part.span));
    case Part::kName:
      return std::string(tree.Text(part.name));
    case Part::kCall: {
      std::string text = std::string(tree.Text(part.name)) + "[";
      for (std::size_t i = 0; i < part.operands.size(); ++i)
        text += operand(i) + ";";
      return text + "]";
    }
    case Part::kNegate:
      return "(-" + operand(0) + ")";
    case Part::kNot:
      return "(not " + operand(0) + ")";
    case Part::kAdd:
      return two("+");
    case Part::kSubtract:
      return two("-");
    case Part::kMultiply:
      return two("*");
    case Part::kDivide:
      return two("/");
    case Part::kLess:
      return two("<");
    case Part::kLessEqual:
      return two("<=");
    case Part::kGreater:
      return two(">");
    case Part::kGreaterEqual:
      return two(">=");
    case Part::kEqual:
      return two("==");
    case Part::kNotEqual:
      return two("!=");
    case Part::kAnd:
      return two(" and ");
    case Part::kOr:
      return two(" or ");
    case Part::kChoice:
      return "(" + operand(0) + "?" + operand(1) + ":" + operand(2) + ")";
  }
  return "";
}

std::string ShapeOf(const std::string& text) {
  const Result<FormulaTree> tree = ParseFormula(text);
  if (!tree) return tree.diagnostics()[0].message;
  return Shape(*tree, tree->parts.size() - 1);
}

TEST_CASE("Formulas group by precedence, from left to right", "[formula]") {
  const std::pair<const char*, const char*> rows[] = {
      {"1", "1"},
      {" a ", "a"},
      {"a + b * c", "(a+(b*c))"},
      {"a - b - c", "((a-b)-c)"},
      {"a / b * c", "((a/b)*c)"},
      {"(a - (b - c))", "(a-(b-c))"},
      {"-a * b", "((-a)*b)"},
      {"a - -b", "(a-(-b))"},
      {"--a", "(-(-a))"},
      {"-(a + b)", "(-(a+b))"},
      {"a + b < c * 2", "((a+b)<(c*2))"},
      {"a<=b", "(a<=b)"},
      {"a >= b or a == b and a != b", "((a>=b) or ((a==b) and (a!=b)))"},
      {"not a < b and True", "((not (a<b)) and True)"},
      {"not not False", "(not (not False))"},
      {"a > 0 ? b : c > 0 ? d : e", "((a>0)?b:((c>0)?d:e))"},
      {"a > 0 ? b > 0 ? c : d : e", "((a>0)?((b>0)?c:d):e)"},
      {"max(a, b + 1, -c)", "max[a;(b+1);(-c);]"},
      {"min (a,\n b)", "min[a;b;]"},
      {"f(g(a), h(b))", "f[g[a;];h[b;];]"},
      {"1e3 + 2.5E-2", "(1e3+2.5E-2)"},
      {"android + order", "(android+order)"},
  };
  for (const auto& [text, shape] : rows) {
    INFO(text);
    CHECK(ShapeOf(text) == shape);
  }
}

TEST_CASE("Places of parts are those of the text", "[formula]") {
  const Result<FormulaTree> tree = ParseFormula("1 + -max(a, 22)");
  REQUIRE(tree);
  const auto text_of = [&](std::size_t i) {
    return tree->Text(tree->parts[i].span);
  };
  CHECK(text_of(tree->parts.size() - 1) == "1 + -max(a, 22)");
  CHECK(text_of(tree->parts.size() - 2) == "-max(a, 22)");
  CHECK(text_of(tree->parts.size() - 3) == "max(a, 22)");
}

TEST_CASE("What is no formula is told at its place", "[formula]") {
  struct Row {
    const char* text;
    std::uint32_t column;  // from 0
    const char* message;
    const char* help;
  };
  const char* const operand =
      "expected a number, a quantity, a function or '(', found ";
  const char* const end =
      "expected an operator or the end of the formula, found ";
  const Row rows[] = {
      {"", 0, operand, ""},
      {"a +", 3, operand, ""},
      {"a b", 2, end, ""},
      {"a = b", 2, end, "write '=='"},
      {"a && b", 2, end, "write 'and'"},
      {"a ^ 2", 2, end, "there is no power"},
      {"a ** 2", 3, operand, "there is no power"},
      {"a < b < c", 6, end, "compare two at a time"},
      {"!a", 0, operand, "write 'not'"},
      {".5", 0, operand, "'0.5'"},
      {"+5", 0, operand, "no '+'"},
      {"5.", 2, "expected digits after '.', found the end", ""},
      {"5e", 2, "expected the digits of an exponent", ""},
      {"3 cm", 2, end, ""},
      {"3cm", 0, "expected an operator after the number, found ", ""},
      {"(a", 2, "expected an operator or ')', found the end", ""},
      {"f(a", 3, "expected an operator, ',' or ')', found the end", ""},
      {"f()", 2, operand, ""},
      {"a > 0 ? 1", 9, "expected an operator, or ':' and what else it is", ""},
      {"a)", 1, end, ""},
      {"50%", 2, end, "percentage"},
      {"\xc3\xa4", 0, operand, ""},
      {"a and and b", 6, operand, ""},
      {"if a", 3, end, ""},
      {"1e999", 0, "no double can hold 1e999", ""},
  };
  for (const Row& row : rows) {
    INFO(row.text);
    const Result<FormulaTree> tree = ParseFormula(row.text);
    REQUIRE_FALSE(tree);
    const Diagnostic& problem = tree.diagnostics()[0];
    CHECK(problem.span.begin == row.column);
    CHECK(problem.message.starts_with(row.message));
    CHECK(problem.help.find(row.help) != std::string::npos);
  }
}

TEST_CASE("Formulas are bounded in length and depth", "[formula]") {
  const std::string deep(kMaxFormulaDepth + 1, '(');
  for (const std::string& text :
       {deep + "a", std::string(kMaxFormulaDepth + 1, '-') + "a",
        std::string(kMaxFormulaLength + 1, ' ') + "a"}) {
    const Result<FormulaTree> tree = ParseFormula(text);
    REQUIRE_FALSE(tree);
    CHECK(tree.diagnostics()[0].code == Code::kLimit);
  }
  CHECK(ParseFormula(std::string(kMaxFormulaDepth, '(') + "a" +
                     std::string(kMaxFormulaDepth, ')')));
  std::string chain = "a";
  while (chain.size() + 2 <= kMaxFormulaLength) chain += "+a";
  CHECK(ParseFormula(chain));
}

}  // namespace
}  // namespace plsc
