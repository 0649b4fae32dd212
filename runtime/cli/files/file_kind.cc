#include "runtime/cli/files/file_kind.h"

#include <algorithm>
#include <array>
#include <vector>

#include "grammar/keywords.h"

namespace plsc::cli {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// "population: 5" -> "population"; empty: not a key of YAML's outermost map.
std::string_view KeyOf(std::string_view line) {
  if (line.starts_with('"') || line.starts_with('\'')) line.remove_prefix(1);
  const auto end = std::find_if_not(line.begin(), line.end(), IsWordCharacter);
  const auto length = static_cast<std::size_t>(end - line.begin());
  const std::string_view key = line.substr(0, length);
  std::string_view rest = line.substr(length);
  if (rest.starts_with('"') || rest.starts_with('\'')) rest.remove_prefix(1);
  const bool is_key =
      rest.starts_with(':') && (rest.size() == 1 || rest[1] == ' ' ||
                                rest[1] == '\t' || rest[1] == '\r');
  return is_key ? key : std::string_view{};
}

bool IsBlank(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  return begin == std::string_view::npos || line[begin] == '#';
}

// The keys of YAML's outermost map, if the first line that says anything has
// one.
std::vector<std::string_view> OutermostKeys(std::string_view text) {
  std::vector<std::string_view> keys;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (IsBlank(line) || line.starts_with("---") || line.starts_with('%'))
      continue;
    const std::string_view key = KeyOf(line);
    if (!key.empty())
      keys.push_back(key);
    else if (keys.empty())
      break;
  }
  return keys;
}

FileKind KindOfJson(std::string_view text) {
  const auto has = [&](std::string_view key) {
    return text.find(key) != std::string_view::npos;
  };
  if (has("\"plsc_golden\"")) return FileKind::kGolden;
  if (has("\"plsc_recording\"")) return FileKind::kRecording;
  // Holds a study as text.
  if (has("\"plsc_digest\"")) return FileKind::kDigest;
  // YAML may be written in braces.
  if (has("plsc_study")) return FileKind::kStudy;
  if (has("plsc_experiment")) return FileKind::kExperiment;
  if (has("plsc_scenario")) return FileKind::kScenario;
  return FileKind::kGenotype;
}

}  // namespace

FileKind KindOf(std::string_view text) {
  if (text.starts_with("SQLite format 3")) return FileKind::kStore;
  if (text.starts_with(kByteOrderMark))
    text.remove_prefix(kByteOrderMark.size());
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin != std::string_view::npos && text[begin] == '{')
    return KindOfJson(text);
  const std::vector<std::string_view> keys = OutermostKeys(text);
  if (keys.empty()) return FileKind::kGenotype;
  const auto has = [&](std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  if (has("plsc_study")) return FileKind::kStudy;
  if (has("plsc_experiment")) return FileKind::kExperiment;
  if (has("plsc_scenario")) return FileKind::kScenario;
  if (has("experiments")) return FileKind::kStudy;
  if (has("seasons")) return FileKind::kScenario;
  return FileKind::kExperiment;
}

}  // namespace plsc::cli
