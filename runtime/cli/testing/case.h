#pragma once

// One test: a genotype in one environment against its golden file, a `test`
// item of the genotype's file, or what is wrong with the file as a whole; and
// what came out. Made by file, shown by report.

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/compare/golden_compare.h"

namespace plsc::cli {

/// A genotype and the golden file that stands beside it; either may be
/// missing.
struct TestPaths {
  std::string genotype;
  std::string golden;

  friend bool operator==(const TestPaths&, const TestPaths&) = default;
};

enum class Verdict : std::uint8_t {
  kSame,
  kDiffers,     ///< `differences` says how; of inline tests `message`
  kUnrecorded,  ///< there is no expectation; `message` says where it lacks
  kError,       ///< nothing to compare; `message` says why
  kUpdated,     ///< --update: the golden file has changed
};

struct TestCase {
  std::string environment;  ///< empty: the file as a whole
  Verdict verdict = Verdict::kSame;
  std::vector<Difference> differences;
  std::string message;     ///< lines with their ends
  std::string genotype{};  ///< of a file of several; else empty
  std::string test{};      ///< name of an inline test; else empty

  bool is_failure() const {
    return verdict != Verdict::kSame && verdict != Verdict::kUpdated;
  }
};

/// All tests of one genotype, at least one.
struct TestedFile {
  TestPaths paths;
  std::vector<TestCase> cases;
};

}  // namespace plsc::cli
