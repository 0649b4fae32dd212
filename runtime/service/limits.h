#pragma once

// What one request may ask for at most. Who asks for more is answered with
// words, before it takes minutes: a page has no other way to end its module
// than to kill it, and texts come from strangers' links.

#include <cstddef>
#include <cstdint>

namespace plsc::service {

/// Bytes of a request; of a genotype's text (it has kilobytes); of a scenario's
/// (64 seasons with every constant are 80 KB, and keys are looked for among all
/// others); of what the file is called.
inline constexpr std::size_t kMostRequestBytes = std::size_t{4} << 20U;
inline constexpr std::size_t kMostTextBytes = std::size_t{1} << 20U;
inline constexpr std::size_t kMostScenarioBytes = std::size_t{256} << 10U;
inline constexpr std::size_t kMostNameBytes = 1024;
inline constexpr std::size_t kMostIdBytes = 256;

/// Environments of a request, and seasons of a scenario.
inline constexpr std::size_t kMostEnvironments = 64;

/// Symbols of the developed strings, of all environments of a request together.
/// The paper's robots have hundreds.
inline constexpr std::uint64_t kMostSymbols = std::uint64_t{1} << 17U;

/// Steps times links, of all seasons together: 15 modules live 100 s of 5 ms
/// steps in at most 300,000, and a million is 1 s with the articulated engine
/// and 10 s with ODE, 45 s of robots of 32 links.
inline constexpr double kMostLinkSteps = 2e6;

/// Numbers that the answer to `parameters` has.
inline constexpr std::size_t kMostNumbers = 10000;

}  // namespace plsc::service
