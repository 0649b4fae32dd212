#pragma once

// A report of a study that claims something, its runs made of numbers: a and b
// in the seasons flat and tilted, five runs each of two generations.

#include "runtime/report/claim_results.h"

namespace plsc::test {

/// About size in flat, of a and b; nothing is stated of a source.
Claim SizeClaim(ClaimKind kind, const std::string& name);

/// Sizes in flat: of a 10 to 14, of b 0 to 4; in tilted 1 more. The best robots
/// have twice as much.
StudyReport ClaimedStudy(const std::vector<Claim>& claims);

/// Claims that a is bigger, and slower, than b. Recorded speeds are as sizes
/// are, relived ones the other way round.
StudyReport RelivedClaims();

}  // namespace plsc::test
