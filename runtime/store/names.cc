#include "runtime/store/names.h"

#include <nlohmann/json.hpp>

#include "grammar/enum_names.h"
#include "grammar/number.h"
#include "runtime/text/json_dump.h"

namespace plsc {

namespace {

using Json = nlohmann::ordered_json;

Json Parse(const std::string& text) {
  return Json::parse(text, nullptr, false);
}

std::optional<std::vector<std::string>> TextsOf(const std::string& text) {
  const Json json = Parse(text);
  if (!json.is_array()) return std::nullopt;
  std::vector<std::string> texts;
  for (const Json& item : json) {
    if (!item.is_string()) return std::nullopt;
    texts.push_back(item.get<std::string>());
  }
  return texts;
}

}  // namespace

std::optional<std::uint64_t> WordOfHex(std::string_view digits) {
  constexpr std::size_t kDigits = 16;
  if (digits.size() != kDigits) return std::nullopt;
  return ParseHex(digits);
}

std::optional<Key> KeyOfHex(std::string_view digits) {
  constexpr std::size_t kHalf = 16;
  if (digits.size() != 2 * kHalf) return std::nullopt;
  const auto high = WordOfHex(digits.substr(0, kHalf));
  const auto low = WordOfHex(digits.substr(kHalf));
  if (!high || !low) return std::nullopt;
  return Key{*high, *low};
}

std::string SensedText(const std::vector<SensedState>& sensed) {
  Json json = Json::object();
  for (const SensedState& state : sensed) json[state.name] = state.value;
  return DumpJson(json);
}

std::string SourcesText(const std::vector<SensedState>& sensed) {
  Json json = Json::object();
  for (const SensedState& state : sensed)
    json[state.name] = NameIn(kSenseSourceNames, state.from);
  return DumpJson(json);
}

std::optional<std::vector<SensedState>> SensedOf(const std::string& sensed,
                                                 const std::string& sources) {
  const Json values = Parse(sensed);
  const Json by = Parse(sources);
  if (!values.is_object() || !by.is_object()) return std::nullopt;
  std::vector<SensedState> states;
  for (const auto& [name, value] : values.items()) {
    const auto from = by.find(name);
    if (!value.is_string() || from == by.end() || !from->is_string())
      return std::nullopt;
    const auto source = ValueIn(kSenseSourceNames, from->get<std::string>());
    if (!source) return std::nullopt;
    states.push_back({name, value.get<std::string>(), *source});
  }
  return states;
}

std::string HeadsText(const std::vector<SymbolId>& heads,
                      const Alphabet& alphabet) {
  Json json = Json::array();
  for (const SymbolId head : heads) json.push_back(alphabet[head].name);
  return DumpJson(json);
}

std::optional<std::vector<SymbolId>> HeadsOf(const std::string& text,
                                             const Alphabet& alphabet) {
  const auto names = TextsOf(text);
  if (!names) return std::nullopt;
  std::vector<SymbolId> heads;
  for (const std::string& name : *names) {
    const auto head = alphabet.Find(name);
    if (!head) return std::nullopt;
    heads.push_back(*head);
  }
  return heads;
}

std::string SensesText(const std::map<std::string, std::string>& senses) {
  Json json = Json::object();
  for (const auto& [name, value] : senses) json[name] = value;
  return DumpJson(json);
}

std::optional<std::map<std::string, std::string>> SensesOf(
    const std::string& text) {
  const Json json = Parse(text);
  if (!json.is_object()) return std::nullopt;
  std::map<std::string, std::string> senses;
  for (const auto& [name, value] : json.items()) {
    if (!value.is_string()) return std::nullopt;
    senses[name] = value.get<std::string>();
  }
  return senses;
}

}  // namespace plsc
