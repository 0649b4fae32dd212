#pragma once

// Recordings as files: `plsc simulate --record` (docs/formats.md has the
// format; docs/decisions/0010 why it is so). Self-contained JSON: what lived,
// where, and every link's pose in time as tracks (track.h).

#include <string>

#include "grammar/result.h"
#include "runtime/recording/recording.h"

namespace plsc {

/// Of the files written here; a reader refuses what is newer.
inline constexpr int kRecordingVersion = 1;

/// What numbers of tracks are multiples of. Rounding moves a point of a robot
/// by 0.02 mm at most, a tenth of what a picture of 1 m on 5000 pixels shows.
inline constexpr double kPositionUnit = 1e-5;         // m
inline constexpr double kTurnUnit = 1.0 / (1 << 15);  // a quaternion's part
inline constexpr double kAngleUnit = 1e-4;            // rad

/// Ends in a newline.
std::string RecordingJson(const Recording& recording);

/// Strict: what is not understood, and numbers that no robot has, are errors
/// at their place. Gives what was written but for the rounding to units, and
/// writes again as the same text.
Result<Recording> ParseRecording(const Source& source);

}  // namespace plsc
