#pragma once

// How long ranks wait between looks for messages, as MPI has no waiting that
// lets the core go: shortly while there is something to do, longer and longer
// when there is not.

#include <algorithm>

namespace plsc {

class MpiPause {
 public:
  /// ms to wait now, given whether the last look found something.
  int Next(bool was_active) {
    pause_ = was_active ? kShortest : std::min(2 * pause_, kLongest);
    return pause_;
  }

 private:
  // A request waits that long at the most, twice on its way; simulations take
  // a second. An idle rank looks a hundred times a second, which costs 0.4 %
  // of a core.
  static constexpr int kLongest = 10;  // ms
  static constexpr int kShortest = 1;
  int pause_ = kShortest;
};

}  // namespace plsc
