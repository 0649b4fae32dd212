#include "compiler/changes/merge_item.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

// An item as it is written.
class Written {
 public:
  explicit Written(const std::string& text)
      : source_("item", "plsc 1\n" + text), file_(ReadItems(source_)) {}
  const WrittenItem* item() const {
    return file_.items.size() > 1 ? &file_.items[1] : nullptr;
  }

 private:
  Source source_;
  WrittenFile file_;
};

struct MergeItemRow {
  const char* why;
  const char* base;
  const char* ours;
  const char* theirs;
  const char* merged;  ///< or "! what of the first clash"
};

void Check(const std::vector<MergeItemRow>& rows) {
  for (const MergeItemRow& row : rows) {
    DYNAMIC_SECTION(row.why) {
      const Written base(row.base);
      const Written ours(row.ours);
      const Written theirs(row.theirs);
      const MergedItem merged =
          MergeItem({base.item(), ours.item(), theirs.item()});
      if (row.merged[0] == '!') {
        REQUIRE_FALSE(merged.clashes.empty());
        CHECK("! " + merged.clashes[0].what == row.merged);
      } else {
        CHECK(merged.clashes.empty());
        CHECK(merged.core + merged.after == row.merged);
      }
    }
  }
}

TEST_CASE("MergeItem merges rules", "[merge_item]") {
  Check({
      {"symbols", "rule B -> { add_left T(1) }", "rule B -> { add_right T(1) }",
       "rule B -> { add_left T(2) }", "rule B -> { add_right T(2) }"},
      {"the clause and a symbol", "rule B -> { T(1) }",
       "rule B -> if a = 1 then { T(1) }", "rule B -> { T(2) }",
       "rule B -> if a = 1 then { T(2) }"},
      {"two terms", "rule B -> if a = 1 and b = 1 then { T(1) }",
       "rule B -> if a = 2 and b = 1 then { T(1) }",
       "rule B -> if a = 1 and b = 2 then { T(1) }",
       "rule B -> if a = 2 and b = 2 then { T(1) }"},
      {"a term and the connective",
       "rule B -> if a = 1 and b = 1 then { T(1) }",
       "rule B -> if a = 1 or b = 1 then { T(1) }",
       "rule B -> if a = 1 and b = 2 then { T(1) }",
       "rule B -> if a = 1 or b = 2 then { T(1) }"},
      {"the first term goes, the second changes",
       "rule B -> if a = 1 and b = 1 then { T(1) }",
       "rule B -> if b = 1 then { T(1) }",
       "rule B -> if a = 1 and b = 2 then { T(1) }",
       "rule B -> if b = 2 then { T(1) }"},
      {"one term in two ways", "rule B -> if a = 1 then { T(1) }",
       "rule B -> if a = 2 then { T(1) }", "rule B -> if a = 3 then { T(1) }",
       "! term 1"},
      {"one symbol in two ways", "rule B -> { T(1) }", "rule B -> { T(2) }",
       "rule B -> { T(3) }", "! symbol 1"},
      {"comments stay with their symbols", "rule B -> {\n  T(1)\n  B\n}",
       "rule B -> {\n  T(1) # one\n  B\n}",
       "rule B -> {\n  T(1)\n  T(3)\n  B\n}",
       "rule B -> {\n  T(1) # one\n  T(3)\n  B\n}"},
      {"a line of symbols, and a comment before one",
       "rule B -> { add_left B }", "rule B -> { add_left B # brick\n}",
       "rule B -> { add_left B T(1) }",
       "rule B -> { add_left B # brick\n T(1)\n}"},
      {"two comments", "rule B -> {\n  B\n}", "rule B -> {\n  B # x\n}",
       "rule B -> {\n  B # y\n}", "! symbol 1"},
  });
}

TEST_CASE("MergeItem merges what else there is", "[merge_item]") {
  Check({
      {"entries", "environment a { b = 1, c = 1 }",
       "environment a { b = 2, c = 1 }", "environment a { b = 1, c = 2 }",
       "environment a { b = 2, c = 2 }"},
      {"a new entry and another value", "environment a { b = 1 }",
       "environment a { b = 1, c = 1 }", "environment a { b = 2 }",
       "environment a { b = 2, c = 1 }"},
      {"a value in two ways", "environment a { b = 1 }",
       "environment a { b = 2 }", "environment a { b = 3 }", "! entry 1"},
      {"the symbols of a test", "test t -> { C B }", "test t -> { C B T }",
       "test t -> { C A1 B }", "test t -> { C A1 B T }"},
      {"heads of a test", "test t -> { C B }", "test t after 1 -> { C B }",
       "test t after 2 -> { C B }", "! the head"},
      {"a constant in two ways", "let a = 1", "let a = 2", "let a = 3", "! "},
      {"a constant and its comment", "let a = 1", "let a = 2",
       "let a = 1 # one", "let a = 2 # one"},
      {"both added", "", "let a = 1", "let  a = 1", "let a = 1"},
      {"both added, different", "", "let a = 1", "let a = 2", "! "},
  });
}

TEST_CASE("SameContent does not look at layout", "[merge_item]") {
  const Written one("rule B -> { T(0.5) }");
  const Written other("rule B -> {\n  T(0.50) # x\n}");
  const Written third("rule B -> { T(0.6) }");
  CHECK(SameContent(*one.item(), *other.item()));
  CHECK_FALSE(SameContent(*one.item(), *third.item()));
}

}  // namespace
}  // namespace plsc
