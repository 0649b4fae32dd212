// Order is merged apart from content. If only one side moved things that all
// three have, its order of what both sides have is kept; if both did, ours
// wins, as order among items that know each other by name means nothing but to
// the reader (rules, where it does, are put into their own order afterwards, by
// merge_section). What one version alone has goes behind the same neighbour as
// there. Both sides' additions at one place are merged by name, so that their
// order does not depend on which side is ours. Linear in the lists.

#include "compiler/changes/merge_order.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace plsc {

namespace {

using Order = std::vector<std::size_t>;

std::vector<bool> MembersOf(const Order& order, std::size_t size) {
  std::vector<bool> members(size, false);
  for (const std::size_t one : order) members[one] = true;
  return members;
}

// Those of `order` that are in all of `groups`.
Order CommonIn(const Order& order,
               const std::vector<const std::vector<bool>*>& groups) {
  Order common;
  for (const std::size_t one : order)
    if (std::all_of(groups.begin(), groups.end(),
                    [&](const auto* group) { return (*group)[one]; }))
      common.push_back(one);
  return common;
}

// Things that one version alone has, behind a thing that both have.
struct Run {
  Order first;   // of the version whose order is kept
  Order second;  // of the other
};

Order Joined(const Run& run, const std::vector<std::string>& names) {
  Order joined;
  std::merge(run.first.begin(), run.first.end(), run.second.begin(),
             run.second.end(), std::back_inserter(joined),
             [&](std::size_t a, std::size_t b) { return names[a] < names[b]; });
  return joined;
}

}  // namespace

std::vector<std::size_t> MergeOrder(const OrderVersions& versions,
                                    const std::vector<std::string>& names) {
  const auto in_base = MembersOf(versions.base, names.size());
  const auto in_ours = MembersOf(versions.ours, names.size());
  const auto in_theirs = MembersOf(versions.theirs, names.size());
  const std::vector<const std::vector<bool>*> all{&in_base, &in_ours,
                                                  &in_theirs};
  const bool is_ours_moved =
      CommonIn(versions.ours, all) != CommonIn(versions.base, all);
  const Order& kept = is_ours_moved ? versions.ours : versions.theirs;
  const Order& other = is_ours_moved ? versions.theirs : versions.ours;
  const std::vector<bool>& in_kept = is_ours_moved ? in_ours : in_theirs;
  const std::vector<bool>& in_other = is_ours_moved ? in_theirs : in_ours;

  // Behind which thing of both; the place before the first is the last run.
  std::vector<Run> runs(names.size() + 1);
  std::size_t behind = names.size();
  for (const std::size_t one : kept) {
    if (in_other[one])
      behind = one;
    else
      runs[behind].first.push_back(one);
  }
  behind = names.size();
  for (const std::size_t one : other) {
    if (in_kept[one])
      behind = one;
    else
      runs[behind].second.push_back(one);
  }
  Order merged = Joined(runs.back(), names);
  for (const std::size_t one : kept) {
    if (!in_other[one]) continue;
    merged.push_back(one);
    const Order joined = Joined(runs[one], names);
    merged.insert(merged.end(), joined.begin(), joined.end());
  }
  return merged;
}

}  // namespace plsc
