#pragma once

// An Evaluation as bytes, for the way from a worker to the run: every double
// bit for bit. Only for two processes of the same program; files are written
// by run_log.

#include <optional>
#include <string>
#include <string_view>

#include "runtime/evaluation.h"

namespace plsc {

std::string Pack(const Evaluation& evaluation);
/// Nothing when the bytes are not a whole one.
std::optional<Evaluation> Unpack(std::string_view bytes);

}  // namespace plsc
