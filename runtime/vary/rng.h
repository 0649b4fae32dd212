#pragma once

// Random numbers by name, not by order of calls: a stream is keyed by who
// needs it and what for, so the order of evaluation and the number of workers
// change no bit of any result. Philox4x64-10 (Salmon et al. 2011) behind the
// door rng.cc. The distributions are our own, because those of the standard
// library differ between its implementations. See
// docs/decisions/0003-random-streams.md.

#include <array>
#include <cstddef>
#include <cstdint>

namespace plsc {

/// What a stream is drawn for. The numbers are part of every result: append,
/// never renumber.
enum class Purpose : std::uint64_t {
  kInitialise = 0,
  kSelectParents = 1,
  kCrossover = 2,
  kMutate = 3,
  kSelectSurvivors = 4,
  /// Of a life: the two numbers between are of a name (evolve/trials).
  kDisturb = 5,
  kRelive = 6,
  kBootstrap = 7,  ///< of a claim's interval, in a report
};

struct StreamKey {
  std::uint64_t seed = 0;        ///< of the run
  std::uint64_t generation = 0;  ///< 0 is the initial population
  std::uint64_t individual = 0;  ///< id; 0 for the population as a whole
  Purpose purpose = Purpose::kInitialise;
};

/// One stream: 2^66 numbers before it repeats, independent of all others.
class Rng {
 public:
  explicit Rng(const StreamKey& key) : key_(key) {}

  std::uint64_t Next();  ///< 64 random bits
  double Uniform();      ///< in [0, 1), multiples of 2^-53
  /// In [low, high]; both finite, low <= high.
  double Uniform(double low, double high);
  /// 0 to count - 1, each exactly as likely; count >= 1.
  std::size_t Index(std::size_t count);
  /// True with the given probability, 0 to 1.
  bool Bernoulli(double probability) { return Uniform() < probability; }
  double Normal();  ///< mean 0, standard deviation 1

 private:
  StreamKey key_;
  std::uint64_t block_ = 0;
  std::array<std::uint64_t, 4> words_{};
  std::size_t used_ = 4;  // of words_
};

}  // namespace plsc
