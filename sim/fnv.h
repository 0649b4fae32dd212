#pragma once

// FNV-1a with 64 bits (offset basis and prime of its authors): a fingerprint
// that is short to compute and the same everywhere. Against accidents; whoever
// wants to can find two inputs of one value.

#include <cstdint>
#include <string_view>

#include "sim/maths/bits.h"

namespace plsc {

class Fnv {
 public:
  void Add(std::string_view text) {
    for (const char c : text) AddByte(static_cast<unsigned char>(c));
  }
  /// Bit for bit.
  void Add(double number) {
    const auto bits = BitCast<std::uint64_t>(number);
    // Byte by byte from the lowest, so that byte order does not matter.
    for (int shift = 0; shift < 64; shift += 8)
      AddByte(static_cast<unsigned char>(bits >> shift));
  }
  std::uint64_t value() const { return value_; }

 private:
  void AddByte(unsigned char byte) { value_ = (value_ ^ byte) * kPrime; }

  static constexpr std::uint64_t kPrime = 0x100000001b3U;
  std::uint64_t value_ = 0xcbf29ce484222325U;  // the offset basis
};

}  // namespace plsc
