#pragma once

// Numbers of the cells of an endless square lattice, drawn from a seed: where
// rough ground rises and where obstacles stand. A number depends on the seed,
// the cell and its ordinal alone, so the ground is the same wherever and
// whenever it is looked at, and nothing of it is stored.

#include <cstdint>

namespace plsc {

/// From 0 to 1, 1 excluded, in steps of 2^-53.
inline double LatticeNoise(std::uint64_t seed, std::int64_t x, std::int64_t y,
                           std::uint64_t ordinal) {
  // SplitMix64 (Steele, Lea and Flood 2014) over what tells cells apart.
  const auto mix = [](std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31);
  };
  std::uint64_t bits = mix(seed);
  bits = mix(bits ^ static_cast<std::uint64_t>(x));
  bits = mix(bits ^ static_cast<std::uint64_t>(y));
  bits = mix(bits ^ ordinal);
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace plsc
