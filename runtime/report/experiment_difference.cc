// Two experiments are compared as they print, key by key with the keys' paths:
// a key that is added to experiments is thereby compared, without a list here
// that would be forgotten. Keys come in the order of the file, those that only
// one has after the key before them.

#include "runtime/report/experiment_difference.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace plsc {

namespace {

using Keys = std::vector<std::pair<std::string, std::string>>;

// A line of PrintExperimentKeys.
struct Line {
  std::size_t depth = 0;  // blanks before it; of a season's first key, behind -
  bool begins_item = false;
  std::string key;
  std::string value;  // empty: a map or a list follows
};

Line SplitLine(std::string_view text) {
  Line line;
  line.depth = text.find_first_not_of(' ');
  if (text.substr(line.depth).starts_with("- ")) {
    line.begins_item = true;
    line.depth += 2;
  }
  const std::string_view rest = text.substr(line.depth);
  const std::size_t colon = rest.find(':');
  line.key = rest.substr(0, colon);
  if (colon + 2 < rest.size()) line.value = rest.substr(colon + 2);
  return line;
}

std::string WithoutQuotes(std::string text) {
  if (text.size() > 1 && text.front() == '"' && text.back() == '"')
    return text.substr(1, text.size() - 2);
  return text;
}

// Every key with its path; a season is called by its name there. The printed
// text is our own, so its layout is known.
Keys KeysOf(const Experiment& experiment) {
  Keys keys;
  std::vector<std::pair<std::size_t, std::string>> path;  // depths and keys
  const std::string text = PrintExperimentKeys(experiment, 0);
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const Line line = SplitLine(rest.substr(0, end));
    rest.remove_prefix(end + 1);
    const std::size_t depth = line.begins_item ? line.depth - 1 : line.depth;
    while (!path.empty() && path.back().first >= depth) path.pop_back();
    if (line.begins_item) {
      path.emplace_back(depth, WithoutQuotes(line.value));
      continue;
    }
    if (line.value.empty()) {
      path.emplace_back(depth, line.key);
      continue;
    }
    std::string name;
    for (const auto& [at, part] : path) name += part + '.';
    keys.emplace_back(name + line.key, line.value);
  }
  return keys;
}

}  // namespace

std::vector<KeyDifference> DifferencesOf(
    const std::vector<Experiment>& experiments) {
  std::vector<Keys> all = {KeysOf(Experiment{})};
  for (const Experiment& one : experiments) all.push_back(KeysOf(one));
  std::vector<std::string> order;
  std::vector<std::map<std::string, std::string>> maps;
  for (const Keys& keys : all) {
    maps.emplace_back(keys.begin(), keys.end());
    auto place = order.begin();
    for (const auto& [key, value] : keys) {
      const auto known = std::find(order.begin(), order.end(), key);
      place = known != order.end() ? known + 1 : order.insert(place, key) + 1;
    }
  }
  std::vector<KeyDifference> differences;
  for (const std::string& key : order) {
    const auto value_in = [&](const std::map<std::string, std::string>& keys) {
      const auto found = keys.find(key);
      return found == keys.end() ? std::nullopt : std::optional(found->second);
    };
    KeyDifference one{key, value_in(maps[0]), {}, false};
    for (std::size_t i = 1; i < maps.size(); ++i)
      one.values.push_back(value_in(maps[i]));
    one.is_between = std::any_of(
        one.values.begin(), one.values.end(),
        [&](const auto& value) { return value != one.values.front(); });
    const bool is_new =
        std::any_of(one.values.begin(), one.values.end(),
                    [&](const auto& value) { return value != one.paper; });
    // How robots are called is no part of the experiment.
    const bool is_name = key == "robots" || key == "scenario.name";
    if (!is_name && (one.is_between || is_new))
      differences.push_back(std::move(one));
  }
  return differences;
}

}  // namespace plsc
