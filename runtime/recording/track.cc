// A pose moves little between two frames, so differences of whole numbers are
// small, and small numbers are short. Whole multiples of a unit are rounded
// once, here, and added up exactly by any reader: with differences of doubles
// errors would grow along the track, and with another rounding two readers
// would see different robots. A decoder takes nothing on trust, neither lengths
// (a row needs a byte a number) nor that a number ends: nine bytes of seven
// bits are more than kMostUnits needs.

#include "runtime/recording/track.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace plsc {

namespace {

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

// RFC 4648, padded.
std::string Base64(const std::string& bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> std::uint32_t {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0;
    };
    const std::uint32_t group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += i + 1 < bytes.size() ? kDigits[group >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? kDigits[group & 63] : '=';
  }
  return text;
}

std::array<std::int8_t, 256> DigitValues() {
  std::array<std::int8_t, 256> values;
  values.fill(-1);
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    values[static_cast<unsigned char>(kDigits[i])] =
        static_cast<std::int8_t>(i);
  return values;
}

std::optional<std::string> BytesOf(std::string_view text) {
  static const std::array<std::int8_t, 256> values = DigitValues();
  if (text.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() &&
         text[text.size() - 1 - padding] == '=')
    ++padding;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t group = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_padding = i >= text.size() - padding;
    const int digit =
        is_padding ? 0 : values[static_cast<unsigned char>(text[i])];
    if (digit < 0) return std::nullopt;
    group = group << 6 | static_cast<std::uint32_t>(digit);
    if (i % 4 != 3) continue;
    for (const int shift : {16, 8, 0})
      bytes += static_cast<char>(group >> shift & 255);
    group = 0;
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

void AppendVarint(std::int64_t number, std::string& bytes) {
  // Zigzag: 0, -1, 1, -2... become 0, 1, 2, 3..., so that small is short.
  auto left = static_cast<std::uint64_t>(number) << 1 ^
              static_cast<std::uint64_t>(number >> 63);
  for (; left > 127; left >>= 7) bytes += static_cast<char>(128 | (left & 127));
  bytes += static_cast<char>(left);
}

// Takes a number from the front of `bytes`; nothing if none is there.
std::optional<std::int64_t> TakeVarint(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < bytes.size() && i < 9; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    number |= static_cast<std::uint64_t>(byte & 127) << (7 * i);
    if (byte > 127) continue;
    bytes.remove_prefix(i + 1);
    return static_cast<std::int64_t>(number >> 1) ^
           -static_cast<std::int64_t>(number & 1);
  }
  return std::nullopt;
}

}  // namespace

std::string EncodeTrack(const Eigen::MatrixXd& numbers, double unit) {
  std::string bytes;
  for (Eigen::Index row = 0; row < numbers.rows(); ++row) {
    std::int64_t last = 0;
    for (Eigen::Index column = 0; column < numbers.cols(); ++column) {
      const double units = numbers(row, column) / unit;
      assert(std::abs(units) <= kMostUnits);
      const std::int64_t number = std::llround(units);
      AppendVarint(number - last, bytes);
      last = number;
    }
  }
  return Base64(bytes);
}

std::optional<Eigen::MatrixXd> DecodeTrack(std::string_view text,
                                           Eigen::Index rows,
                                           Eigen::Index columns, double unit) {
  const auto decoded = BytesOf(text);
  if (!decoded) return std::nullopt;
  // Each number takes a byte at least: nothing is allocated on a file's word.
  const auto bytes = static_cast<Eigen::Index>(decoded->size());
  if (rows > 0 && columns > bytes / rows) return std::nullopt;
  std::string_view left = *decoded;
  Eigen::MatrixXd numbers(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row) {
    std::int64_t number = 0;
    for (Eigen::Index column = 0; column < columns; ++column) {
      const auto difference = TakeVarint(left);
      if (!difference) return std::nullopt;
      number += *difference;
      if (std::abs(static_cast<double>(number)) > kMostUnits)
        return std::nullopt;
      numbers(row, column) = static_cast<double>(number) * unit;
    }
  }
  if (!left.empty()) return std::nullopt;
  return numbers;
}

}  // namespace plsc
