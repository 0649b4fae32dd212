#include "fuzz/mutate_text.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

// libFuzzer's own mutation, by bytes and with the dictionary.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                        std::size_t max_size);

namespace plsc::fuzz {

namespace {

enum class Kind { kName, kNumber, kMark };

struct Word {
  std::size_t begin = 0;
  std::size_t size = 0;
  Kind kind = Kind::kMark;
};

bool IsDigit(char c) {
  return c >= '0' && c <= '9';
}
bool IsLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

Kind KindAt(char c) {
  if (IsLetter(c)) return Kind::kName;
  return IsDigit(c) || c == '-' ? Kind::kNumber : Kind::kMark;
}

std::vector<Word> WordsOf(const std::string& text) {
  std::vector<Word> words;
  for (std::size_t i = 0; i < text.size();) {
    const char first = text[i];
    Word word{i, 1, KindAt(first)};
    if (word.kind == Kind::kName)
      while (i + word.size < text.size() &&
             (IsLetter(text[i + word.size]) || IsDigit(text[i + word.size])))
        ++word.size;
    if (word.kind == Kind::kNumber)
      while (i + word.size < text.size() &&
             (IsDigit(text[i + word.size]) || text[i + word.size] == '.'))
        ++word.size;
    i += word.size;
    if (first != ' ' && first != '\n') words.push_back(word);
  }
  return words;
}

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    lines.push_back(text.substr(begin, end + 1 - begin));
    begin = end + 1;
  }
  return lines;
}

class Mutation {
 public:
  explicit Mutation(std::uint32_t seed) : engine_(seed) {}

  std::string Of(const std::string& text) {
    switch (Below(6)) {
      case 0:
        return ChangeLines(text);
      case 1:
        return PutInComment(text);
      default:
        return ReplaceWord(text);
    }
  }

 private:
  std::size_t Below(std::size_t n) { return engine_() % n; }

  std::string ReplaceWord(const std::string& text) {
    const std::vector<Word> words = WordsOf(text);
    if (words.empty()) return text;
    const Word old = words[Below(words.size())];
    std::string changed = text;
    if (Below(8) == 0) return changed.erase(old.begin, old.size);
    // Any word of its kind, looked for from a random one on.
    const std::size_t first = Below(words.size());
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Word& word = words[(first + i) % words.size()];
      if (word.kind != old.kind || word.begin == old.begin) continue;
      return changed.replace(old.begin, old.size,
                             text.substr(word.begin, word.size));
    }
    return changed;
  }

  std::string ChangeLines(const std::string& text) {
    std::vector<std::string> lines = LinesOf(text);
    const std::size_t from = Below(lines.size());
    const std::size_t to = Below(lines.size());
    switch (Below(3)) {
      case 0:
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(from));
        break;
      case 1:
        std::swap(lines[from], lines[to]);
        break;
      default:
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(to),
                     std::string(lines[from]));
        break;
    }
    std::string changed;
    for (const std::string& line : lines) changed += line;
    return changed;
  }

  std::string PutInComment(const std::string& text) {
    const std::vector<Word> words = WordsOf(text);
    if (words.empty()) return text;
    static constexpr const char* kComments[] = {"# c\n", "\n# c\n", " ", "\n",
                                                "# plsc: allow W3002\n"};
    return std::string(text).insert(words[Below(words.size())].begin,
                                    kComments[Below(std::size(kComments))]);
  }

  std::mt19937 engine_;
};

}  // namespace

std::string MutateText(const std::string& text, std::uint32_t seed) {
  return Mutation(seed).Of(text);
}

}  // namespace plsc::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data,
                                               std::size_t size,
                                               std::size_t max_size,
                                               unsigned int seed) {
  if (size == 0 || seed % 3 == 0) return LLVMFuzzerMutate(data, size, max_size);
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string changed = plsc::fuzz::MutateText(text, seed / 3);
  const std::size_t length = std::min(changed.size(), max_size);
  if (length == 0) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data, changed.data(), length);
  return length;
}
