#pragma once

// The number of the arithmetic. Raised by 1 whenever the same genotype,
// scenario and seed come to other bits: when a change moves what develops, what
// is drawn or what is lived. Runs store it, keys of simulations hold it, a run
// is gone on with by its own only, and whoever repeats an older one knows why
// it comes out otherwise.
//
// 1: everything up to version 0.1.0.
// 2: functions of the project's own in place of libm's; the articulated engine.

namespace plsc {

inline constexpr int kResults = 2;

}  // namespace plsc
