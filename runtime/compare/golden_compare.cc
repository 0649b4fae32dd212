// Facts are compared one kind after the other, from causes to effects: what was
// sensed, which rules were active, the string, then the robot. A person reads
// the first line and mostly knows. Strings are shown where they part and join
// again; of a string that was cut and hashed the end is not known, so it is not
// compared from behind. All is exact but descriptors, which go through exp and
// may differ in last bits from machine to machine.

#include "runtime/compare/golden_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "grammar/number.h"
#include "runtime/compare/robot_parts.h"

namespace plsc {

namespace {

// Symbols shown on each side where two strings differ.
constexpr std::size_t kExcerptSymbols = 6;

std::string Excerpt(const std::vector<std::string>& symbols, std::size_t begin,
                    std::size_t end) {
  if (begin == end) return "nothing";
  const std::size_t last = std::min(end, begin + kExcerptSymbols);
  std::string text = fmt::format(
      "{}",
      fmt::join(symbols.begin() + static_cast<std::ptrdiff_t>(begin),
                symbols.begin() + static_cast<std::ptrdiff_t>(last), " "));
  if (last < end) text += fmt::format(" ... ({} symbols)", end - begin);
  return text;
}

// What stands between the equal beginning and the equal end of both.
void CompareSymbols(const GoldenString& expected, const GoldenString& found,
                    std::vector<Difference>& differences) {
  const auto& e = expected.symbols;
  const auto& f = found.symbols;
  const std::size_t shorter = std::min(e.size(), f.size());
  std::size_t begin = 0;
  while (begin < shorter && e[begin] == f[begin]) ++begin;
  std::size_t end = 0;  // counted from the end
  // The ends of strings that go on are no ends.
  if (expected.hash.empty() && found.hash.empty())
    while (end < shorter - begin &&
           e[e.size() - 1 - end] == f[f.size() - 1 - end])
      ++end;
  if (begin == e.size() - end && begin == f.size() - end) return;
  differences.push_back(
      {DifferenceKind::kChanged, fmt::format("string at symbol {}", begin + 1),
       Excerpt(e, begin, e.size() - end), Excerpt(f, begin, f.size() - end)});
}

void CompareStrings(const GoldenString& expected, const GoldenString& found,
                    std::vector<Difference>& differences) {
  if (expected == found) return;
  CompareSymbols(expected, found, differences);
  if (expected.length != found.length)
    differences.push_back({DifferenceKind::kChanged, "length of the string",
                           std::to_string(expected.length),
                           std::to_string(found.length)});
  else if (expected.hash != found.hash)
    differences.push_back({DifferenceKind::kChanged, "hash of the string",
                           expected.hash, found.hash});
}

bool IsClose(double expected, double found, double tolerance) {
  return std::abs(expected - found) <=
         tolerance * std::max(1.0, std::abs(expected));
}

void CompareValues(const GoldenValues& expected, const GoldenValues& found,
                   double tolerance, std::vector<Difference>& differences) {
  std::map<std::string_view, double> rest(found.begin(), found.end());
  for (const auto& [name, value] : expected) {
    const auto same = rest.find(name);
    if (same == rest.end()) {
      differences.push_back(
          {DifferenceKind::kMissing, "descriptor " + name, "", ""});
      continue;
    }
    if (!IsClose(value, same->second, tolerance))
      differences.push_back({DifferenceKind::kChanged, "descriptor " + name,
                             PrintNumber(value), PrintNumber(same->second)});
    rest.erase(same);
  }
  for (const auto& [name, value] : found)
    if (rest.contains(name))
      differences.push_back(
          {DifferenceKind::kAdded, "descriptor " + name, "", ""});
}

void CompareBodies(const Observation& expected, const Observation& found,
                   double tolerance, std::vector<Difference>& differences) {
  if (expected.robot.has_value() != found.robot.has_value()) {
    differences.push_back(
        {expected.robot ? DifferenceKind::kMissing : DifferenceKind::kAdded,
         "body and brain", "", ""});
    return;
  }
  if (!expected.robot) return;
  const GoldenRobot& e = *expected.robot;
  const GoldenRobot& f = *found.robot;
  CompareParts(e, f, differences);
  CompareValues(e.body_descriptors, f.body_descriptors, tolerance, differences);
  CompareValues(e.brain_descriptors, f.brain_descriptors, tolerance,
                differences);
}

std::string Numbers(const std::vector<int>& numbers) {
  return numbers.empty() ? "none" : fmt::format("{}", fmt::join(numbers, " "));
}

}  // namespace

std::vector<Difference> Compare(const Observation& expected,
                                const Observation& found, double tolerance) {
  std::vector<Difference> differences;
  if (expected.senses != found.senses)
    differences.push_back(
        {DifferenceKind::kChanged, "what the environment means",
         expected.senses.empty() ? "nothing" : expected.senses,
         found.senses.empty() ? "nothing" : found.senses});
  if (expected.active_rules != found.active_rules)
    differences.push_back({DifferenceKind::kChanged, "active rules",
                           Numbers(expected.active_rules),
                           Numbers(found.active_rules)});
  CompareStrings(expected.string, found.string, differences);
  CompareBodies(expected, found, tolerance, differences);
  return differences;
}

}  // namespace plsc
