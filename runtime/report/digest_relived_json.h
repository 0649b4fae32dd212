#pragma once

// A digest's part about lives that a run's last generation lived again: what
// boxes, tests, claims and swap tests of a report are made of, not the lives.

#include <nlohmann/json.hpp>

#include "runtime/report/digest.h"
#include "runtime/text/json_reader.h"

namespace plsc {

/// Of the digest's measures, and of those that swap tests are about, in SI.
nlohmann::ordered_json KeptRelived(const Digest& digest, const DigestRun& one);

/// `seasons`: names of the run's. Of a measure that was not kept nothing is
/// known.
RelivedReading ReadKeptRelived(JsonReader& reader, const JsonValue& relived,
                               const std::vector<std::string>& seasons);

}  // namespace plsc
