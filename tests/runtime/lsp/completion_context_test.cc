#include "runtime/lsp/completion_context.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("The words before the cursor say what may come", "[lsp]") {
  struct Row {
    const char* text;
    Wanted wanted;
  };
  using enum Wanted;
  const std::vector<Row> rows = {
      {"@", kItem},
      {"plsc @", kNothing},
      {"plsc 1\n@", kItem},
      {"plsc 1\nru@", kItem},
      {"rule @", kHead},
      {"rule B@", kHead},
      {"rule B @", kNothing},
      {"rule B -> @", kClauseOrBrace},
      {"rule B -> if @", kState},
      {"rule B -> if incl@", kState},
      {"rule B -> if a @", kComparison},
      {"rule B -> if a = @", kValue},
      {"rule B -> if a >= @", kValue},
      {"rule B -> if a = True @", kConnective},
      {"rule B -> if a > 3 @", kConnective},
      {"rule B -> if a = True and @", kState},
      {"rule B -> if a = True then @", kBrace},
      {"rule B -> { @", kSymbol},
      {"rule B -> { C add@ }", kSymbol},
      {"rule B -> { T(@", kConstant},
      {"rule B -> { T(0.5) @", kSymbol},
      {"rule B -> { T(0.@", kNothing},
      {"rule B -> { B }\n@", kItem},
      {"rule B -> { B } @ rule C", kItem},
      {"environment @", kNothing},
      {"environment e { @", kEntry},
      {"environment e { a @", kNothing},
      {"environment e { a = @", kValue},
      {"environment e { a = True, @", kEntry},
      {"environment e { a = True } @", kItem},
      {"sense a@", kNothing},
      {"sense a: @", kType},
      {"sense a: bool\n@", kItem},
      {"sense g: { dry, @", kNothing},
      {"alphabet @", kAlphabet},
      {"alphabet plasticoding 1 @", kItem},
      {"alphabet own { replaceable @", kNothing},
      {"axiom @", kAxiom},
      {"move_to_new @", kTruth},
      {"let @", kNothing},
      {"let x = @", kNothing},
      {"let x = 3\n@", kItem},
      {"iterations @", kNothing},
      {"genotype test\n@", kItem},
      {"test @", kNothing},
      {"test t @", kTestWord},
      {"test t in @", kEnvironment},
      {"test t in e @", kTestWord},
      {"test t in e after 2 -> @", kExpectation},
      {"test t -> { @", kSymbol},
      {"test t -> body @", kModule},
      {"test t -> body C { @", kFace},
      {"test t -> body C { front @", kModule},
      {"test t -> { C } @", kItem},
      {"# rule @", kNothing},
      {"rule # if\n @", kHead},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.text) {
      const Marked marked(row.text);
      CHECK(ContextAt(marked.text, marked.offset).wanted == row.wanted);
    }
  }
}

TEST_CASE("The context knows the state and what was given", "[lsp]") {
  const Marked value("rule B -> if a = True and ground != we@");
  const CompletionContext context = ContextAt(value.text, value.offset);
  CHECK(context.subject == "ground");
  CHECK(context.word == Span{value.offset - 2, value.offset});
  const Marked entry("environment e { a = True, b = False, @");
  CHECK(ContextAt(entry.text, entry.offset).given ==
        std::vector<std::string_view>{"a", "b"});
}

TEST_CASE("Any place of any text has a context", "[lsp]") {
  const std::string text = std::string(kGecko) + "\n= = { ( } ) \xFF -> if";
  for (std::uint32_t at = 0; at <= text.size(); ++at) {
    const CompletionContext context = ContextAt(text, at);
    CHECK(context.word.end == at);
  }
}

}  // namespace plsc::lsp
