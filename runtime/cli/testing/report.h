#pragma once

// What `plsc test` tells: for people as text, for scripts a JSON object a
// test. junit has the third form.

#include <string>

#include "runtime/cli/testing/case.h"

namespace plsc::cli {

struct TestTotals {
  int files = 0;
  int tests = 0;
  int same = 0;
  int differ = 0;
  int unrecorded = 0;
  int errors = 0;
  int updated = 0;
  int recordable = 0;  ///< failures that --update would make expectations

  bool has_failures() const { return differ + unrecorded + errors > 0; }
};

void Count(const TestedFile& tested, TestTotals& totals);

/// Tests that passed are not mentioned.
std::string TestText(const TestedFile& tested);
/// The last line or two of the text.
std::string TestSummary(const TestTotals& totals);

/// A line a test: file, golden, genotype (null: the only one), test (name of
/// an inline test, or null), environment (null: the file as a whole),
/// verdict (same, differs, unrecorded, error, updated), differences (kind,
/// what, expected, found), message.
std::string TestJson(const TestedFile& tested);

}  // namespace plsc::cli
