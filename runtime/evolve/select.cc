// Tournaments with replacement (authors' program, selection.py:6-46), repeated
// until enough different individuals have won. That is not the same as drawing
// without replacement: who has won stays in the pool and makes further
// tournaments void, so that the pressure is that of the paper. Ties go to whom
// was drawn first, which with few distinct counts is often; numbers are drawn
// in a fixed order, as they are part of every result.
//
// A tournament costs its size; half of a pool of 200 takes about 140.

#include "runtime/evolve/select.h"

#include <algorithm>
#include <cassert>

namespace plsc {

namespace {

// Tournaments in a row that only give individuals who have won before. Half of
// a pool of 200 is found in about 140 tournaments of 2; but with tournaments of
// 10, taking all of it would take 200^10. Beyond this limit the best that has
// not won is taken, so that selection always ends.
constexpr int kMaxTournaments = 100'000;

std::size_t BestNotChosen(const std::vector<int>& scores,
                          const std::vector<bool>& is_chosen) {
  std::size_t best = scores.size();
  for (std::size_t i = 0; i < scores.size(); ++i)
    if (!is_chosen[i] && (best == scores.size() || scores[i] > scores[best]))
      best = i;
  return best;
}

}  // namespace

std::size_t Tournament(const std::vector<int>& scores, int size, Rng& rng) {
  assert(!scores.empty() && size >= 1);
  std::size_t winner = rng.Index(scores.size());
  for (int i = 1; i < size; ++i) {
    const std::size_t rival = rng.Index(scores.size());
    if (scores[rival] > scores[winner]) winner = rival;
  }
  return winner;
}

std::vector<std::size_t> SelectDistinct(
    const std::vector<int>& scores, std::size_t count, int tournament_size,
    Rng& rng, const std::function<bool()>& should_stop) {
  assert(count <= scores.size());
  std::vector<std::size_t> chosen;
  std::vector<bool> is_chosen(scores.size(), false);
  while (chosen.size() < count && !(should_stop && should_stop())) {
    std::size_t winner = Tournament(scores, tournament_size, rng);
    for (int i = 1; is_chosen[winner] && i < kMaxTournaments; ++i)
      winner = Tournament(scores, tournament_size, rng);
    if (is_chosen[winner]) winner = BestNotChosen(scores, is_chosen);
    is_chosen[winner] = true;
    chosen.push_back(winner);
  }
  return chosen;
}

}  // namespace plsc
