#include "runtime/history/history_view.h"

#include "runtime/develop/part_names.h"
#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

TEST_CASE("a symbol leads to its text and its place", "[history_view]") {
  const auto grown = test::Grow(test::kTwoGenerations, Environment{{0}});
  const HistoryView view = grown.view();
  // C B add_front A1(...) mutate_amp(1)
  const Occurrence& joint = view.At(3).occurrence;
  CHECK(SymbolText(view.genotype, joint) == "A1(0.5, 2, 3, 4)");
  CHECK(NameOf(view.genotype, joint) == "A1");
  CHECK(PlaceText(view.source, SpanOf(view, joint)) == "robot.pls:5:23");
  const Insertion& axiom = view.history.derivation[0];
  CHECK(SymbolText(view.genotype, axiom.occurrence) == "C");
  CHECK(SpanOf(view, axiom.occurrence) == Span{});
}

TEST_CASE("a written axiom has a place", "[history_view]") {
  const auto grown =
      test::Grow("plsc 1 alphabet plasticoding 1\naxiom C", Environment{});
  const Occurrence axiom = grown.history.derivation[0].occurrence;
  CHECK(PlaceText(grown.source, SpanOf(grown.view(), axiom)) ==
        "robot.pls:2:7");
}

}  // namespace
}  // namespace plsc
