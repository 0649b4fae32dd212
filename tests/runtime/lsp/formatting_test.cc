#include "runtime/lsp/formatting.h"

#include <catch2/catch.hpp>

#include "compiler/format.h"
#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

TEST_CASE("Formatting makes the text of plsc fmt", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nrule C -> { C   B }   # why\n";
  const Analysis analysis(kTestUri, text);
  const std::string formatted = *Format(Source("f", text));
  CHECK(formatted != text);
  CHECK(Edited(text, FormattingEdits(analysis)) == formatted);
  const Analysis again(kTestUri, formatted);
  CHECK(FormattingEdits(again) == Json::array());
}

TEST_CASE("A broken text is not formatted", "[lsp]") {
  const Analysis analysis(kTestUri, "plsc 1\nrule C -> {");
  CHECK(FormattingEdits(analysis).is_null());
}

TEST_CASE("Of a range only its lines are laid out", "[lsp]") {
  const std::string text =
      "plsc 1\n\nalphabet plasticoding 1\n\nrule C -> {\n    C\n  B\n}\n\n"
      "rule B -> {\n    B\n}\n";
  const Analysis analysis(kTestUri, text);
  std::string first = text;
  first.replace(first.find("    C"), 5, "  C");
  CHECK(Edited(text, FormattingEdits(analysis, 4, 7)) == first);
  CHECK(Edited(text, FormattingEdits(analysis, 5, 5)) == first);
  CHECK(FormattingEdits(analysis, 6, 8) == Json::array());
  CHECK(Edited(text, FormattingEdits(analysis, 0, 99)) ==
        *Format(Source("f", text)));
}

TEST_CASE("What would move out of a range stays", "[lsp]") {
  const std::string text =
      "plsc 1\n\niterations 2\n\nrule C -> {\n  C\n}\n\n"
      "alphabet plasticoding 1\n";
  const Analysis analysis(kTestUri, text);
  const Json of_alphabet = FormattingEdits(analysis, 8, 8);
  CHECK((of_alphabet.is_null() || of_alphabet.empty()));
  CHECK(Edited(text, FormattingEdits(analysis, 0, 9)) ==
        *Format(Source("f", text)));
  CHECK(FormattingEdits(Analysis(kTestUri, "plsc 1\nrule"), 0, 1).is_null());
}

}  // namespace plsc::lsp
