#pragma once

// The rule of every three-way merge: what one side left alone is what the other
// made of it.

namespace plsc {

/// What both sides, or the one that changed the base, made of it; nullptr where
/// they changed it in different ways.
template <typename T>
const T* Choose(const T& base, const T& ours, const T& theirs) {
  if (ours == theirs || theirs == base) return &ours;
  return ours == base ? &theirs : nullptr;
}

}  // namespace plsc
