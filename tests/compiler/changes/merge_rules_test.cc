#include "compiler/changes/merge_rules.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

// Rules of B, of texts such as "{ T(0.5) }", and their items.
class Rules {
 public:
  explicit Rules(const std::vector<std::string>& bodies)
      : source_("rules", TextOf(bodies)), file_(ReadItems(source_)) {
    for (const WrittenItem& item : file_.items)
      if (item.kind == ast::ItemKind::kRule) rules.push_back(&item);
  }
  WrittenRules rules;

 private:
  static std::string TextOf(const std::vector<std::string>& bodies) {
    std::string text = "plsc 1\nalphabet plasticoding 1\n";
    for (const std::string& body : bodies) text += "rule B -> " + body + '\n';
    return text;
  }
  Source source_;
  WrittenFile file_;
};

constexpr const char* kLeft = "{ add_left B move_left add_left T(0.5) }";
constexpr const char* kLeftMore = "{ add_left B move_left add_left T(0.75) }";
constexpr const char* kRight = "if a = True then { add_right A1(1, 2, 3, 4) }";

TEST_CASE("MatchRules finds the same rule in three versions", "[merge_rules]") {
  const Rules base({kLeft, kRight});
  const Rules ours({kLeftMore, kRight});
  const auto matched = MatchRules(base.rules, ours.rules, base.rules);
  REQUIRE(matched.size() == 2);
  CHECK(matched[0].versions.base == base.rules[0]);
  CHECK(matched[0].versions.ours == ours.rules[0]);
  CHECK_FALSE(matched[0].clash);
}

TEST_CASE("MatchRules leaves out what a side deleted", "[merge_rules]") {
  const Rules base({kLeft, kRight});
  const Rules ours({kRight});
  const auto matched = MatchRules(base.rules, ours.rules, base.rules);
  REQUIRE(matched.size() == 1);
  CHECK(matched[0].versions.ours == ours.rules[0]);
}

TEST_CASE("MatchRules tells of rules that clash", "[merge_rules]") {
  const Rules base({kLeft});
  SECTION("both added one at the same place") {
    const Rules ours({kLeft, kRight});
    const Rules theirs({kLeft, "if b = True then { T(0.1) }"});
    const auto matched = MatchRules(base.rules, ours.rules, theirs.rules);
    REQUIRE(matched.size() == 2);
    CHECK(matched[1].clash == ClashKind::kBothInserted);
  }
  SECTION("deleted and changed") {
    const Rules ours({});
    const Rules theirs({kLeftMore});
    const auto matched = MatchRules(base.rules, ours.rules, theirs.rules);
    REQUIRE(matched.size() == 1);
    CHECK(matched[0].clash == ClashKind::kDeletedAndChanged);
    CHECK(matched[0].versions.ours == nullptr);
  }
}

}  // namespace
}  // namespace plsc
