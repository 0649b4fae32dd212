// nlohmann-json does not tell where a value stands. Texts that parsed are
// scanned a second time, only when there is something to report, by brackets
// and quotes alone: the path of keys and indices to the value is followed from
// the beginning. Linear in the text for each question, which is why readers
// stop after some errors (kMaxErrors).
//
// Two questions are asked before parsing, because the library would answer them
// by overflowing the stack or silently: how deep the text nests, and whether a
// key is there twice.

#include "runtime/text/json_place.h"

#include <unordered_set>

namespace plsc {

namespace {

Span MakeSpan(std::size_t begin, std::size_t end) {
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

// Every function takes an offset and gives the one behind what it read; all
// stop at the end of the text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  char At(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }
  bool IsEnd(std::size_t i) const { return i >= text_.size(); }

  // Blanks and what stands between values.
  std::size_t SkipFill(std::size_t i) const {
    while (!IsEnd(i) && std::string_view(" \t\r\n,:").find(text_[i]) !=
                            std::string_view::npos)
      ++i;
    return i;
  }

  std::size_t SkipString(std::size_t i) const {
    for (++i; !IsEnd(i) && text_[i] != '"'; ++i)
      if (text_[i] == '\\') ++i;
    return IsEnd(i) ? text_.size() : i + 1;
  }

  std::size_t SkipValue(std::size_t i) const {
    if (At(i) == '"') return SkipString(i);
    if (At(i) != '{' && At(i) != '[') return SkipWord(i);
    std::size_t depth = 0;
    while (!IsEnd(i)) {
      const char c = text_[i];
      if (c == '"') {
        i = SkipString(i);
        continue;
      }
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      ++i;
      if (depth == 0) break;
    }
    return i;
  }

  std::string_view Between(std::size_t begin, std::size_t end) const {
    return text_.substr(begin, end - begin);
  }

 private:
  std::size_t SkipWord(std::size_t i) const {
    while (!IsEnd(i) && std::string_view(" \t\r\n,:]}").find(text_[i]) ==
                            std::string_view::npos)
      ++i;
    return i;
  }

  std::string_view text_;
};

struct Entry {
  std::size_t key = 0;  // of an element of an array: the value
  std::size_t value = 0;
};

// What `step` names in the object or array that begins at `i`.
std::optional<Entry> Enter(const Scanner& scanner, std::size_t i,
                           const std::string& step) {
  const bool is_object = scanner.At(i) == '{';
  if (!is_object && scanner.At(i) != '[') return std::nullopt;
  const std::string quoted = '"' + step + '"';
  i = scanner.SkipFill(i + 1);
  for (std::size_t index = 0; !scanner.IsEnd(i); ++index) {
    if (scanner.At(i) == '}' || scanner.At(i) == ']') return std::nullopt;
    const std::size_t key = i;
    bool is_wanted = !is_object && std::to_string(index) == step;
    if (is_object) {
      const std::size_t end = scanner.SkipString(i);
      is_wanted = scanner.Between(i, end) == quoted;
      i = scanner.SkipFill(end);
    }
    if (is_wanted) return Entry{key, i};
    i = scanner.SkipFill(scanner.SkipValue(i));
  }
  return std::nullopt;
}

Entry Follow(const Scanner& scanner, const std::vector<std::string>& path) {
  Entry entry;
  entry.key = entry.value = scanner.SkipFill(0);
  for (const std::string& step : path) {
    const auto inside = Enter(scanner, entry.value, step);
    if (!inside) break;
    entry = *inside;
  }
  return entry;
}

// Of a whole object or array the bracket is enough to point at.
Span SpanOf(const Scanner& scanner, std::size_t i) {
  if (scanner.At(i) == '{' || scanner.At(i) == '[') return MakeSpan(i, i + 1);
  return MakeSpan(i, scanner.SkipValue(i));
}

}  // namespace

Span JsonPlaceOf(std::string_view text, const std::vector<std::string>& path) {
  const Scanner scanner(text);
  return SpanOf(scanner, Follow(scanner, path).value);
}

Span JsonKeyPlaceOf(std::string_view text,
                    const std::vector<std::string>& path) {
  const Scanner scanner(text);
  return SpanOf(scanner, Follow(scanner, path).key);
}

std::optional<Span> TooDeepInJson(std::string_view text) {
  const Scanner scanner(text);
  int depth = 0;
  for (std::size_t i = 0; !scanner.IsEnd(i);) {
    const char c = scanner.At(i);
    if (c == '"') {
      i = scanner.SkipString(i);
      continue;
    }
    if ((c == '[' || c == '{') && ++depth > kMaxJsonDepth)
      return MakeSpan(i, i + 1);
    if (c == ']' || c == '}') --depth;
    ++i;
  }
  return std::nullopt;
}

std::optional<Span> RepeatedJsonKey(std::string_view text) {
  const Scanner scanner(text);
  std::vector<std::unordered_set<std::string_view>> keys;
  for (std::size_t i = 0; !scanner.IsEnd(i);) {
    const char c = scanner.At(i);
    if (c == '{' || c == '[') keys.emplace_back();
    if ((c == '}' || c == ']') && !keys.empty()) keys.pop_back();
    if (c != '"') {
      ++i;
      continue;
    }
    const std::size_t end = scanner.SkipString(i);
    std::size_t next = end;
    while (scanner.At(next) == ' ' || scanner.At(next) == '\n' ||
           scanner.At(next) == '\t' || scanner.At(next) == '\r')
      ++next;
    if (scanner.At(next) == ':' && !keys.empty() &&
        !keys.back().insert(scanner.Between(i, end)).second)
      return MakeSpan(i, end);
    i = end;
  }
  return std::nullopt;
}

}  // namespace plsc
