#include "runtime/compare/brain_difference.h"

#include "tests/runtime/develop/grown.h"

namespace plsc {
namespace {

using Marks = std::vector<ModuleMark>;
using enum ModuleMark;

Phenotype Robot(const std::string& symbols) {
  return test::GrowProduction(symbols).trace().phenotype;
}

const char* const kFirst =
    "add_left T(0.5) add_front A1(-0.7,1.6,6.4,2.3) loop(-1)";

TEST_CASE("A brain does not differ from itself", "[brain_difference]") {
  const BrainDifference difference =
      CompareBrains(Robot(kFirst), Robot(kFirst));
  CHECK(difference.nodes == Marks{kShared, kShared});
  CHECK(difference.edges == Marks{kShared, kShared});
  CHECK_FALSE(difference.has_missing());
}

TEST_CASE(
    "Parts of a brain are the same where they hang, whatever their "
    "numbers in order",
    "[brain_difference]") {
  // The sensor on the right comes first, and takes the numbers.
  const BrainDifference difference = CompareBrains(
      Robot(kFirst), Robot("add_right T(0.5) add_left T(0.5) "
                           "add_front A1(-0.7,1.6,6.4,2.3) loop(-1)"));
  CHECK(difference.nodes == Marks{kNew, kShared, kShared});
  CHECK(std::count(difference.edges.begin(), difference.edges.end(), kNew) ==
        1);
  CHECK_FALSE(difference.has_missing());
}

TEST_CASE("Every number of a part counts", "[brain_difference]") {
  for (const char* joint :
       {"A1(-0.6,1.6,6.4,2.3)", "A1(-0.7,1.7,6.4,2.3)", "A1(-0.7,1.6,6.5,2.3)",
        "A1(-0.7,1.6,6.4,2.4)", "A2(-0.7,1.6,6.4,2.3)"}) {
    INFO(joint);
    const BrainDifference difference =
        CompareBrains(Robot(kFirst), Robot(std::string("add_left T(0.5) ") +
                                           "add_front " + joint + " loop(-1)"));
    CHECK(difference.nodes == Marks{kShared, kOther});
    CHECK_FALSE(difference.has_missing());
  }
  CHECK(CompareBrains(Robot(kFirst),
                      Robot("add_left T(0.5) "
                            "add_front A1(-0.7,1.6,6.4,2.3) loop(-0.9)"))
            .edges == Marks{kShared, kOther});
}

TEST_CASE("What is gone is told, and comparing the other way it is new",
          "[brain_difference]") {
  const Phenotype first = Robot(kFirst);
  const Phenotype other = Robot("add_left T(0.5)");
  const BrainDifference gone = CompareBrains(first, other);
  CHECK(gone.nodes == Marks{kShared});
  CHECK(gone.missing_nodes == std::vector<int>{1});
  CHECK(gone.missing_edges == std::vector<int>{0, 1});
  const BrainDifference found = CompareBrains(other, first);
  CHECK(found.nodes == Marks{kShared, kNew});
  CHECK(found.edges == Marks{kNew, kNew});
  CHECK_FALSE(found.has_missing());
}

}  // namespace
}  // namespace plsc
