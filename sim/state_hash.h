#pragma once

// A fingerprint of numbers, bit for bit (FNV-1a, 64 bits). Tells whether two
// simulations ended in the same state; equal only on one machine kind and one
// set of libraries.

#include <bit>
#include <cstdint>

namespace plsc {

class StateHash {
 public:
  void Add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    // Byte by byte from the lowest, so that byte order does not matter.
    for (int shift = 0; shift < 64; shift += 8) {
      value_ ^= (bits >> shift) & 0xffU;
      value_ *= 0x100000001b3U;  // the FNV prime
    }
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;  // the FNV offset basis
};

}  // namespace plsc
