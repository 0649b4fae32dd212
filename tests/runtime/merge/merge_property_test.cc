// What holds of every merge, over random programs of any kind and over what
// evolution makes.

#include <catch2/catch.hpp>

#include "compiler/changes/merge_program.h"
#include "compiler/compile.h"
#include "compiler/format.h"
#include "compiler/print.h"
#include "tests/compiler/random_genotype.h"
#include "tests/runtime/merge/mutation_pair.h"
#include "tests/sanitizer.h"

namespace plsc::test {
namespace {

// Texts at 40 seeds take a second.
constexpr std::uint32_t kPrograms = 40;

MergedFile Merge(const std::string& base, const std::string& ours,
                 const std::string& theirs) {
  return MergeFiles(Source("base", base), Source("ours", ours),
                    Source("theirs", theirs));
}

// The same program in another layout, with a comment: so that merging has work
// to do where only one side says something else.
std::string Relaid(const std::string& text) {
  FormatOptions options;
  options.compact = true;
  options.compile.allow_out_of_range = true;
  const auto compact = Format(Source("text", text), options);
  REQUIRE(compact);
  return *compact + "# the end\n";
}

Program Compiled(const std::string& text) {
  CompileOptions options;
  options.allow_out_of_range = true;
  const auto program = Compile(Source("text", text), options);
  INFO(text);
  REQUIRE(program);
  return *program;
}

TEST_CASE("A side that did not change leaves the other as it is",
          "[merge][property]") {
  for (std::uint32_t seed = 0; seed < kPrograms; ++seed) {
    const std::string base = Print(testing::RandomProgram(seed));
    const std::string other = Print(testing::RandomProgram(seed + kPrograms));
    INFO("seed " << seed);
    for (const auto& [ours, theirs] :
         {std::pair{other, base}, std::pair{base, other},
          std::pair{other, other}, std::pair{base, base}}) {
      const MergedFile merged = Merge(base, ours, theirs);
      CHECK(merged.conflicts.empty());
      CHECK(merged.text == (ours == base ? theirs : ours));
    }
  }
}

TEST_CASE("A new layout of one side goes with the changes of the other",
          "[merge][property]") {
  for (std::uint32_t seed = 0; seed < kPrograms; ++seed) {
    const Program old_program = testing::RandomProgram(seed);
    const Program new_program = testing::RandomProgram(seed + kPrograms);
    const std::string base = Print(old_program);
    const std::string other = Print(new_program);
    const std::string relaid = Relaid(base);
    INFO("seed " << seed);
    for (const auto& [ours, theirs] :
         {std::pair{other, relaid}, std::pair{relaid, other}}) {
      const MergedFile merged = Merge(base, ours, theirs);
      REQUIRE(merged.conflicts.empty());
      CHECK(Compiled(merged.text) == new_program);
      CHECK(merged.text.find("# the end") != std::string::npos);
    }
  }
}

TEST_CASE("Mutations merge to both, whichever side is ours",
          "[merge][property]") {
  int composed = 0;
  for (std::uint64_t i = 1000; i < 1000 + Sampled(400U); ++i) {
    const MutationPair pair = DrawMutationPair(i);
    const std::string base = Print(pair.base);
    const std::string ours = Print(pair.ours);
    const std::string theirs = Print(pair.theirs);
    INFO("pair " << i);
    const MergedFile merged = Merge(base, ours, theirs);
    const MergedFile swapped = Merge(base, theirs, ours);
    CHECK(merged.conflicts.empty() == pair.composed.has_value());
    CHECK(swapped.conflicts.size() == merged.conflicts.size());
    if (!pair.composed) continue;
    ++composed;
    CHECK(merged.text == Print(*pair.composed));
    CHECK(swapped.text == merged.text);
    // Both sides in other layouts: the same genotype.
    const MergedFile relaid = Merge(base, Relaid(ours), theirs);
    REQUIRE(relaid.conflicts.empty());
    CHECK(Compiled(relaid.text).genotype == *pair.composed);
  }
  CHECK(composed > (PLSC_HAS_ASAN ? 38 : 390));
}

TEST_CASE("Unrelated programs merge, or conflict, without an end in between",
          "[merge][property]") {
  for (std::uint32_t seed = 0; seed < kPrograms; ++seed) {
    const std::string base = Print(testing::RandomProgram(seed));
    const std::string ours = Print(testing::RandomProgram(seed + 1000));
    const std::string theirs = Print(testing::RandomProgram(seed + 2000));
    INFO("seed " << seed);
    const MergedFile merged = Merge(base, ours, theirs);
    const MergedFile swapped = Merge(base, theirs, ours);
    CHECK(merged.conflicts.empty() == swapped.conflicts.empty());
    const bool has_markers =
        merged.text.find("<<<<<<< ours\n") != std::string::npos;
    CHECK(has_markers == !merged.conflicts.empty());
  }
}

}  // namespace
}  // namespace plsc::test
