#pragma once

// Series of numbers as short text, for recordings: whole multiples of a unit,
// each as the difference to the one before, in as few bytes as it needs
// (LEB128 of the zigzag number), in base64. What moves slowly takes a byte a
// number; docs/formats.md has a reader of 15 lines.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>

namespace plsc {

/// Numbers are at most this many units, so that readers whose only numbers are
/// doubles have them exactly.
inline constexpr double kMostUnits = 9007199254740992.0;  // 2^53

/// Row after row. The numbers must be finite and at most kMostUnits units.
std::string EncodeTrack(const Eigen::MatrixXd& numbers, double unit);

/// Nothing unless `text` is exactly `rows` x `columns` numbers.
std::optional<Eigen::MatrixXd> DecodeTrack(std::string_view text,
                                           Eigen::Index rows,
                                           Eigen::Index columns, double unit);

}  // namespace plsc
