#include "runtime/text/yaml_text.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "runtime/text/yaml_words.h"

namespace plsc {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Of a text in double quotes: what yaml-cpp leaves as it is, and strict readers
// refuse or take for an end of line.
std::string WithEscapes(std::string_view quoted) {
  std::string text;
  for (std::size_t i = 0; i < quoted.size(); ++i) {
    const std::string_view rest = quoted.substr(i);
    const bool is_control = rest.size() > 1 && rest[0] == '\xC2' &&
                            static_cast<unsigned char>(rest[1]) < 0xA0;
    if (rest[0] == '\x7F') {
      text += "\\x7F";
    } else if (is_control) {
      text += fmt::format("\\x{:02X}", static_cast<unsigned char>(rest[1]));
      i += 1;
    } else if (rest.starts_with("\u2028") || rest.starts_with("\u2029")) {
      text += rest[2] == '\xA8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else if (rest.starts_with(kByteOrderMark)) {
      text += "\\uFEFF";
      i += 2;
    } else {
      text += rest[0];
    }
  }
  return text;
}

}  // namespace

std::string PrintYamlText(std::string_view text) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_plain = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9');
  };
  const bool is_word = !text.empty() && is_letter(text[0]) &&
                       std::all_of(text.begin(), text.end(), is_plain);
  if (is_word && !IsYamlWord(text)) return std::string(text);
  YAML::Emitter emitter;
  // JSON's quoting is also YAML's, and the only one that shows control
  // characters.
  emitter << YAML::DoubleQuoted << std::string(text);
  return WithEscapes(emitter.c_str());
}

}  // namespace plsc
