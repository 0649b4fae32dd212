#pragma once

// Results of `plsc test` as JUnit XML, which GitLab, Jenkins and others show:
// a suite a genotype, a case an environment. No times: the same results give
// the same bytes.

#include <string>
#include <string_view>

#include "runtime/cli/testing/report.h"

namespace plsc::cli {

/// One <testsuite>.
std::string JunitSuite(const TestedFile& tested);

/// The document around the suites.
std::string JunitDocument(const TestTotals& totals, std::string_view suites);

/// Any bytes as text of an XML attribute or element: marked characters are
/// escaped; what is no UTF-8, or no character of XML 1.0, becomes U+FFFD.
std::string JunitText(std::string_view bytes);

}  // namespace plsc::cli
