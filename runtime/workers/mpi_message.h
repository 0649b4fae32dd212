#pragma once

// What rank 0 and the ranks that lend it their workers tell each other.
// Requests and answers are the texts that workers get and give on one machine
// too. Ranks are the same program (the first message makes sure of it), so
// numbers are sent as they lie in memory.

#include <cstdint>
#include <string>

namespace plsc {

enum class RankWord : std::uint8_t {
  // To rank 0.
  kHello,      ///< after kBegin: `number` workers, `text` is ProgramVersion
  kWorkers,    ///< there are only `number` now
  kAnswer,     ///< `text` answers request `number`
  kDeath,      ///< two workers died on request `number`, the second of `text`
  kCancelled,  ///< request `number` will not be answered
  kAllCancelled,  ///< after the last kCancelled
  kFailure,       ///< no workers any more, because of `text`
  kBye,           ///< the last
  // From rank 0.
  kBegin,   ///< the first of a run: workers hang after `text` (a double) s
  kWork,    ///< request `number`
  kCancel,  ///< forget the requests that no worker has begun
  kEnd,     ///< the last
};

struct RankWords {
  RankWord word = RankWord::kBye;
  int number = 0;
  std::string text;

  friend bool operator==(const RankWords&, const RankWords&) = default;
};

std::string Encode(const RankWords& words);
/// Of a text that Encode made.
RankWords Decode(const std::string& message);

/// What must be equal on all ranks, as results are a function of it too.
std::string ProgramVersion();

}  // namespace plsc
