// Holm 1979, "A simple sequentially rejective multiple test procedure": the
// smallest of n is multiplied by n, the next one by n - 1, and so on; none
// becomes less than one before it, nor more than 1.

#include "runtime/report/holm.h"

#include <algorithm>

namespace plsc {

std::vector<std::optional<double>> HolmAdjusted(
    const std::vector<std::optional<double>>& family) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < family.size(); ++i)
    if (family[i]) order.push_back(i);
  std::stable_sort(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return *family[a] < *family[b]; });
  std::vector<std::optional<double>> adjusted(family.size());
  double most = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const auto factor = static_cast<double>(family.size() - rank);
    most = std::max(most, std::min(1.0, factor * *family[order[rank]]));
    adjusted[order[rank]] = most;
  }
  return adjusted;
}

}  // namespace plsc
