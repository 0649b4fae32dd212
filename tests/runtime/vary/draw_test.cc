#include "runtime/vary/draw.h"

#include <catch2/catch.hpp>
#include <set>
#include <vector>

#include "tests/runtime/vary/chi_square.h"

namespace plsc {

using test::kSignificance;
using test::PValue;

TEST_CASE("Symbols of a category are as likely, and C is never drawn",
          "[draw]") {
  const Alphabet& alphabet = *PlasticodingAlphabet();
  for (const Category category :
       {Category::kModule, Category::kMounting, Category::kMoving,
        Category::kControllerMoving, Category::kControllerChanging}) {
    std::vector<SymbolId> ids = alphabet.OfCategory(category);
    std::erase(ids, plasticoding::kC);
    CAPTURE(ids.size());
    std::vector<int> counts(alphabet.symbols().size());
    Rng rng({21, 0, 0, Purpose::kMutate});
    for (int i = 0; i < 20000; ++i)
      ++counts[static_cast<std::size_t>(
          DrawSymbol(alphabet, category, rng).id)];
    std::vector<int> seen;
    int total = 0;
    for (const SymbolId id : ids) {
      seen.push_back(counts[static_cast<std::size_t>(id)]);
      total += seen.back();
    }
    CHECK(total == 20000);
    CHECK(PValue(seen, std::vector<double>(seen.size(), 1)) > kSignificance);
  }
}

TEST_CASE("Terms about an enum take any value with = or !=", "[draw]") {
  const std::vector<State> states = {
      {"ground", StateType::kEnum, 0, 0, {"sand", "rock", "wet"}}};
  std::vector<int> counts(6);
  Rng rng({22, 0, 0, Purpose::kMutate});
  for (int i = 0; i < 20000; ++i) {
    const Term term = DrawTerm(states, rng);
    REQUIRE(term.comparison <= Comparison::kNotEqual);
    ++counts[static_cast<std::size_t>(term.comparison) * 3 +
             static_cast<std::size_t>(term.value)];
  }
  CHECK(PValue(counts, std::vector<double>(6, 1)) > kSignificance);
}

}  // namespace plsc
