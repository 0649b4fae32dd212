#pragma once

// When a study said what it expects: FOLDER/claims.yaml, written before the
// first run, and one file more for each change afterwards (claims.2.yaml), with
// its time, its hash and how many runs there were. No file is ever rewritten,
// so that nothing that was claimed is lost; a seal tells what was changed by
// hand or by accident. It is no proof against forgery: who needs one publishes
// the hash.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/expected.h"
#include "grammar/failure.h"
#include "runtime/study/claim.h"
#include "runtime/study/report_measures.h"

namespace plsc {

struct Study;

/// All claims of the study, as they were from then on.
struct ClaimsVersion {
  std::string stated;  ///< UTC, "2026-11-30T12:00:00Z"
  int runs = 0;        ///< of the study
  int runs_begun = 0;  ///< until then, those that were done included
  int runs_done = 0;
  std::string hash;           ///< KeyOf their text, PrintClaims without indent
  std::vector<Claim> claims;  ///< none: those before were withdrawn
};

/// The latest is the last; empty: the study claims nothing, and never did.
using ClaimsRecord = std::vector<ClaimsVersion>;

/// Writes the study's claims into its folder, as PrepareFolder leaves it,
/// unless they are the last that stand there. `now` is UTC. Of several
/// processes that begin at once, one writes.
MaybeFailure StateClaims(const std::string& folder, const Study& study,
                         const std::string& now);

/// Fails if a file is damaged, was changed by hand, or is missing.
Expected<ClaimsRecord, Failure> ClaimsIn(const std::string& folder);

/// The files themselves, the first one first, to be kept elsewhere; and what
/// they say. `where` they are from is part of what is told to be wrong.
Expected<std::vector<std::string>, Failure> ClaimsTextsIn(
    const std::string& folder);
Expected<ClaimsRecord, Failure> ParseClaimsRecord(
    const std::vector<std::string>& texts, const std::string& where);

/// Adds those that were ever claimed of, unless they are there.
void AddClaimedMeasures(const ClaimsRecord& record,
                        std::vector<ReportMeasure>& measures);

/// A claim that was ever made in the folder.
struct StatedClaim {
  Claim claim;
  std::size_t since = 0;  ///< the version from which on it stands as it is
  /// The version that has it no more, or has it otherwise.
  std::optional<std::size_t> withdrawn;
};
/// Those that stand, in their order, and then the withdrawn ones.
std::vector<StatedClaim> StatedClaims(const ClaimsRecord& record);

/// "before the first run", "after 3 of 80 runs had begun (1 was done)"
std::string WhenStated(const ClaimsVersion& version);

}  // namespace plsc
