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

}  // namespace plsc::lsp
