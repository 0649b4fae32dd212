#include "compiler/compiled.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "compiler/verify.h"

namespace plsc::testing {

Program Compiled(const std::string& text) {
  const Source source("a.pls", text);
  const Result<Program> result = Compile(source);
  INFO(text);
  INFO(Render(result.diagnostics(), source));
  REQUIRE(result);
  // Compile itself asks this in debug builds only.
  REQUIRE(Verify(*result) == std::vector<std::string>());
  return *result;
}

std::string CodesOf(const std::string& text) {
  const Result<Program> result = Compile(Source("a.pls", text));
  std::string codes;
  for (const Diagnostic& diagnostic : result.diagnostics())
    codes +=
        (codes.empty() ? "" : " ") + std::string(NumberOf(diagnostic.code));
  return codes;
}

}  // namespace plsc::testing
