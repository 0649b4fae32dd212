#include "runtime/text/diagnostic_json.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace plsc {
namespace {

TEST_CASE("a diagnostic keeps its parts in JSON", "[diagnostic_json]") {
  const Source source("a.pls", "one\ntöö two\n");
  Diagnostic diagnostic(Code::kUnknownItem, {10, 13},
                        "expected one, found two");
  diagnostic.others = {{{0, 3}, "one is here"}};
  diagnostic.fixes = {{{10, 13}, "one"}};
  const auto json = nlohmann::json::parse(DiagnosticJson(diagnostic, source));
  CHECK(json["severity"] == "error");
  CHECK(json["code"] == "P1101");
  CHECK(json["line"] == 2);
  CHECK(json["column"] == 5);  // characters, not bytes
  CHECK(json["byte_begin"] == 10);
  CHECK(json["others"][0]["line"] == 1);
  CHECK(json["fixes"][0]["replacement"] == "one");
}

TEST_CASE("text that is not UTF-8 stays valid JSON", "[diagnostic_json]") {
  const Diagnostic diagnostic(Code::kUnknownItem, {}, "found '\xFF'");
  CHECK(
      nlohmann::json::accept(DiagnosticJson(diagnostic, Source("a", "\xFF"))));
}

}  // namespace
}  // namespace plsc
