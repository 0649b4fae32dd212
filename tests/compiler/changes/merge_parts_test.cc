#include "compiler/changes/merge_parts.h"

#include <fmt/format.h>
#include <catch2/catch.hpp>

namespace plsc {
namespace {

WrittenPart Part(const std::string& name, std::vector<std::string> values) {
  WrittenPart part;
  part.content = {name, std::move(values)};
  part.text = PartText(part.content);
  part.before = " ";
  return part;
}

std::string Texts(const MergedParts& merged) {
  std::string text;
  for (const WrittenPart& part : merged.parts) text += part.text + ' ';
  return text;
}

TEST_CASE("PartText writes a symbol", "[merge_parts]") {
  CHECK(PartText({"B", {}}) == "B");
  CHECK(PartText({"A1", {"0.5", "2"}}) == "A1(0.5, 2)");
}

TEST_CASE("ReplacementCost is less for less of a change", "[merge_parts]") {
  const PartContent joint{"A1", {"1", "2", "3", "4"}};
  CHECK(ReplacementCost(joint, joint) == 0);
  const int one = ReplacementCost(joint, {"A1", {"1", "2", "3", "5"}});
  const int two = ReplacementCost(joint, {"A1", {"1", "2", "5", "5"}});
  const int other = ReplacementCost(joint, {"B", {}});
  CHECK(0 < one);
  CHECK(one < two);
  CHECK(two < other);
  // Of equal terms nobody guesses which one was removed.
  CHECK(ReplacementCost({"hot", {"and", "=", "True"}},
                        {"hot", {"", "=", "True"}}) == 0);
  CHECK(ReplacementCost({"hot", {"", "=", "True"}},
                        {"hot", {"and", "=", "True"}}) > 0);
}

TEST_CASE("MergeParts merges arguments one by one", "[merge_parts]") {
  const std::vector<WrittenPart> base{Part("C", {}),
                                      Part("A1", {"0.5", "2", "3", "1"})};
  const std::vector<WrittenPart> ours{Part("C", {}),
                                      Part("A1", {"0.6", "2", "3", "1"})};
  const std::vector<WrittenPart> theirs{
      Part("C", {}), Part("A1", {"0.5", "2", "3", "4"}), Part("B", {})};
  const MergedParts merged =
      MergeParts({&base, &ours, &theirs}, PartIdentity::kPlace);
  CHECK(merged.clashes.empty());
  CHECK(Texts(merged) == "C A1(0.6, 2, 3, 4) B ");
}

TEST_CASE("MergeParts tells where one argument has two values",
          "[merge_parts]") {
  const std::vector<WrittenPart> base{Part("C", {}), Part("T", {"1"})};
  const std::vector<WrittenPart> ours{Part("C", {}), Part("T", {"2"})};
  const std::vector<WrittenPart> theirs{Part("C", {}), Part("T", {"3"})};
  const MergedParts merged =
      MergeParts({&base, &ours, &theirs}, PartIdentity::kPlace);
  REQUIRE(merged.clashes.size() == 1);
  CHECK(merged.clashes[0].kind == ClashKind::kBothChanged);
  CHECK(merged.clashes[0].position == 2);
  CHECK(merged.clashes[0].base == &base[1]);
  CHECK(merged.clashes[0].ours == &ours[1]);
  CHECK(merged.clashes[0].theirs == &theirs[1]);
}

TEST_CASE("Parts with names never become each other", "[merge_parts]") {
  const std::vector<WrittenPart> base{Part("hot", {"True"})};
  const std::vector<WrittenPart> ours{Part("wet", {"True"})};
  const EditCosts by_name = CostsOfParts(base, ours, PartIdentity::kName);
  const EditCosts by_place = CostsOfParts(base, ours, PartIdentity::kPlace);
  CHECK(by_name.replace(0, 0) > 2 * by_name.one);
  CHECK(by_place.replace(0, 0) < 2 * by_place.one);
}

TEST_CASE("MergeValue chooses what changed", "[merge_parts]") {
  CHECK(MergeValue("1", "2", "1") == "2");
  CHECK(MergeValue("1", "1", "2") == "2");
  CHECK(MergeValue("1", "2", "2") == "2");
  CHECK_FALSE(MergeValue("1", "2", "3"));
}

}  // namespace
}  // namespace plsc
