#include "runtime/service/numbers.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "compiler/compile.h"
#include "grammar/number.h"
#include "tests/runtime/service/asked.h"

namespace plsc::service {
namespace {

constexpr const char* kTurnable =
    "plsc 1\nalphabet plasticoding 1\niterations 2\nmax_modules 9\n"
    "move_to_new True\n"
    "sense warmth: real in -40..60\nsense wet: bool\n"
    "let mild = 12.5\nlet few = 3\nlet unused = 4.5\n"
    "rule C -> if warmth > 20.5 and wet = True or warmth < mild then {\n"
    "  C\n  add_front\n  A1(0.5, 2, 3.25, few)\n  move_ref_N(few, 1)\n"
    "  mutate_amp(-0.25)\n}\n"
    "environment cool { warmth = 5, wet = False }\n";

struct Numbers {
  explicit Numbers(const std::string& text)
      : analysis("a.pls", text), all(NumbersOf(analysis)) {}

  const TurnableNumber& Called(const std::string& name) const {
    for (const TurnableNumber& number : all)
      if (number.name == name) return number;
    FAIL(name);
    return all.front();
  }
  std::string At(const std::string& place) {
    const std::size_t at = analysis.text().find(place);
    REQUIRE(at != std::string_view::npos);
    const auto found = NumberAt(analysis, all, static_cast<std::uint32_t>(at));
    return found ? found->kind + " " + found->name : "";
  }

  lsp::Analysis analysis;
  std::vector<TurnableNumber> all;
};

TEST_CASE("numbers know what they are and how far they go", "[service]") {
  const Numbers numbers(kTurnable);
  std::vector<std::string> names;
  for (const TurnableNumber& number : numbers.all)
    names.push_back(number.kind + " " + number.name + " " +
                    PrintNumber(number.value));
  CHECK(names == std::vector<std::string>{
                     "setting iterations 2", "setting max_modules 9",
                     "constant mild 12.5", "constant few 3",
                     "constant unused 4.5", "threshold warmth 20.5",
                     "argument w of A1 0.5", "argument a of A1 2",
                     "argument p of A1 3.25", "argument d of move_ref_N 1",
                     "argument m of mutate_amp -0.25", "sensed warmth 5"});
  CHECK(numbers.Called("iterations").is_whole);
  CHECK(numbers.Called("iterations").highest == 100);
  CHECK(numbers.Called("max_modules").lowest == 1);
  CHECK(numbers.Called("a of A1").lowest == 1);
  CHECK(numbers.Called("a of A1").highest == 10);
  CHECK_FALSE(numbers.Called("a of A1").is_whole);
  CHECK(numbers.Called("d of move_ref_N").is_whole);
  CHECK(std::isinf(numbers.Called("m of mutate_amp").highest));
  CHECK(numbers.Called("warmth").lowest == -40);
  // Of all that it is used for: an offset of A1 and a count.
  CHECK(numbers.Called("few").is_whole);
  CHECK(numbers.Called("few").lowest == 1);
  CHECK(numbers.Called("few").highest == 10);
  CHECK(numbers.Called("mild").highest == 60);
  CHECK(numbers.Called("w of A1").about.find("of `A1`") != std::string::npos);
  CHECK_FALSE(numbers.Called("iterations").about.empty());
}

TEST_CASE("the number at a place is the one it touches, or the nearest",
          "[service]") {
  Numbers numbers(kTurnable);
  CHECK(numbers.At("3.25") == "argument p of A1");
  CHECK(numbers.At(", 3.25") == "argument a of A1");  // behind it
  CHECK(numbers.At("A1(") == "argument w of A1");
  CHECK(numbers.At("20.5") == "threshold warmth");
  CHECK(numbers.At("warmth > ") == "threshold warmth");
  CHECK(numbers.At("iterations") == "setting iterations");
  CHECK(numbers.At("few, 1") == "constant few");
  CHECK(numbers.At("mild then") == "constant mild");
  CHECK(numbers.At("add_front").empty());
  CHECK(numbers.At("plsc").empty());
}

TEST_CASE("sliders are finite, hold the value and step in round numbers",
          "[service]") {
  const Numbers numbers(kTurnable);
  const auto slider = [&](const char* name) {
    const SliderRange range = SliderOf(numbers.Called(name));
    return std::vector<double>{range.from, range.to, range.step};
  };
  CHECK(slider("iterations") == std::vector<double>{0, 100, 1});
  CHECK(slider("a of A1") == std::vector<double>{1, 10, 0.1});
  CHECK(slider("w of A1") == std::vector<double>{-1, 1, 0.02});
  CHECK(slider("m of mutate_amp") == std::vector<double>{-4, 4, 0.1});
  CHECK(slider("d of move_ref_N") == std::vector<double>{1, 8, 1});
  CHECK(slider("warmth") == std::vector<double>{-40, 60, 1});
  TurnableNumber huge;
  huge.value = 1e308;
  huge.lowest = -std::numeric_limits<double>::infinity();
  huge.highest = std::numeric_limits<double>::infinity();
  const SliderRange range = SliderOf(huge);
  CHECK(std::isfinite(range.from));
  CHECK(std::isfinite(range.to));
  CHECK(range.step > 0);
}

TEST_CASE("numbers of a broken text are those that could be read",
          "[service]") {
  const Numbers broken(
      "plsc 1\nalphabet plasticoding 1\nrul B -> { A1(1) }\n"
      "rule C -> { C add_front A1(0.5, 99.5, nothing, 1) Z(3) loop(1, 2) }\n"
      "rule B -> { A1(0.5 ");
  std::vector<double> values;
  for (const TurnableNumber& number : broken.all)
    values.push_back(number.value);
  CHECK(values == std::vector<double>{0.5, 99.5, 1, 1});
}

TEST_CASE("what several genotypes share is told once", "[service]") {
  const Numbers numbers(
      "plsc 1\nalphabet plasticoding 1\nlet x = 2\n"
      "genotype one\nrule C -> { C add_front A1(0.5, x, 2, 1) }\n"
      "genotype two\nrule C -> { C move_ref_N(x, 1) }\n");
  CHECK(numbers.all.size() == 5);
  CHECK(numbers.Called("x").is_whole);
  CHECK(numbers.Called("x").highest == 10);
}

TEST_CASE("every number of an example may go to the ends of its slider",
          "[service]") {
  for (const auto& [name, text] : test::ExampleTexts()) {
    const Numbers numbers(text);
    for (std::size_t i = 0; i < numbers.all.size(); i += 7) {
      const TurnableNumber& number = numbers.all[i];
      CHECK(number.value ==
            ParseNumber<double>(std::string_view(text).substr(
                number.span.begin, number.span.end - number.span.begin)));
      if (number.kind == "setting") continue;  // may break a rule of the file
      const SliderRange range = SliderOf(number);
      CHECK(range.from <= number.value);
      CHECK(number.value <= range.to);
      for (const double end : {range.from, range.to}) {
        std::string turned = text;
        turned.replace(number.span.begin, number.span.end - number.span.begin,
                       PrintNumber(end));
        INFO(name << " " << number.name << " " << end);
        CHECK(CompileAll(Source(name, turned)));
      }
    }
  }
}

}  // namespace
}  // namespace plsc::service
