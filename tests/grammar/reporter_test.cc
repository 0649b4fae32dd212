#include "grammar/reporter.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("What is reported is kept with all that is said of it",
          "[reporter]") {
  Reporter reporter;
  reporter.Report(Code::kUnknownSymbol, {1, 2}, "m")
      .WithLabel("l")
      .WithOther({0, 1}, "o")
      .WithNote("n")
      .WithHelp("h")
      .WithFix({1, 2}, "f");
  CHECK(reporter.has_errors());
  const std::vector<Diagnostic> taken = reporter.Take();
  REQUIRE(taken.size() == 1);
  CHECK(taken[0].code == Code::kUnknownSymbol);
  CHECK(taken[0].severity == Severity::kError);
  CHECK(taken[0].span == Span{1, 2});
  CHECK(taken[0].message == "m");
  CHECK(taken[0].label == "l");
  CHECK(taken[0].others.at(0).text == "o");
  CHECK(taken[0].notes == std::vector<std::string>{"n"});
  CHECK(taken[0].help == "h");
  CHECK(taken[0].fixes.at(0).replacement == "f");
  CHECK(reporter.diagnostics().empty());
  CHECK_FALSE(reporter.has_errors());
}

TEST_CASE("The last within the limit is whole, the next goes nowhere",
          "[reporter]") {
  Reporter reporter(2);
  reporter.Report(Code::kUnknownSymbol, {}, "first");
  CHECK_FALSE(reporter.is_full());
  reporter.Report(Code::kUnknownSymbol, {}, "last").WithHelp("its help");
  CHECK(reporter.is_full());
  reporter.Report(Code::kUnknownSymbol, {}, "beyond").WithHelp("nowhere");
  reporter.Report(Code::kUnsensedState, {}, "beyond").WithHelp("nowhere");
  REQUIRE(reporter.diagnostics().size() == 2);
  CHECK(reporter.diagnostics()[1].message == "last");
  CHECK(reporter.diagnostics()[1].help == "its help");
}

TEST_CASE("Warnings alone leave room for the first error", "[reporter]") {
  Reporter reporter(2);
  for (int i = 0; i < 3; ++i) reporter.Report(Code::kUnsensedState, {}, "w");
  CHECK(reporter.diagnostics().size() == 2);
  CHECK_FALSE(reporter.Takes(Severity::kWarning));
  CHECK(reporter.Takes(Severity::kError));
  CHECK_FALSE(reporter.is_full());
  CHECK_FALSE(reporter.has_errors());
  for (int i = 0; i < 3; ++i) reporter.Report(Code::kUnknownState, {}, "e");
  CHECK(reporter.diagnostics().size() == 3);
  CHECK(reporter.is_full());
  CHECK(reporter.has_errors());
}

}  // namespace
}  // namespace plsc
