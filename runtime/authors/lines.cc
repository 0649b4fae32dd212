// The older lines that Revolve still reads (plasticoding.py:135-151): a letter
// a line, then its symbols with their parameters behind '_'.

#include <fmt/format.h>

#include <utility>

#include "grammar/number.h"
#include "grammar/reporter.h"
#include "runtime/authors/cursor.h"
#include "runtime/authors/genotype.h"

namespace plsc {

namespace {

// Its samples have six decimals behind each point.
constexpr std::size_t kDecimals = 6;

bool IsRounded(std::string_view number) {
  const std::size_t point = number.find('.');
  return point != std::string_view::npos &&
         number.size() - point - 1 == kDecimals;
}

class LinesReader {
 public:
  explicit LinesReader(const Source& source) : source_(source) {}

  AuthorsText Read() {
    for (int line = 1; line <= source_.line_count(); ++line) {
      // Of a hostile text nobody reads more.
      if (reporter_.is_full()) break;
      ReadLine(line);
    }
    if (rounded_)
      reporter_.Report(
          Code::kLost, *rounded_,
          "numbers with six decimals were rounded when they were "
          "written; the robot may differ a little from its original");
    read_.problems = reporter_.Take();
    return std::move(read_);
  }

 private:
  void ReadLine(int number) {
    const std::string_view line = source_.Line(number);
    const std::uint32_t begin = source_.LineBegin(number);
    std::vector<Span> words;
    std::size_t at = number == 1 ? TextBegin(line) : 0;
    while ((at = line.find_first_not_of(" \t\r", at)) !=
           std::string_view::npos) {
      const std::size_t end =
          std::min(line.find_first_of(" \t\r", at), line.size());
      words.push_back({begin + static_cast<std::uint32_t>(at),
                       begin + static_cast<std::uint32_t>(end)});
      at = end;
    }
    if (words.empty()) return;
    AuthorsRule rule{WordAt(words.front()), {}, words.front(), {}};
    for (std::size_t i = 1; i < words.size(); ++i)
      rule.symbols.push_back(WordAt(words[i]));
    const bool is_dropped =
        words.size() > 1 && words.back().end == begin + line.size();
    if (is_dropped)
      reporter_.Report(
          Code::kLost, words.back(),
          fmt::format("without a blank at the end of the line Revolve "
                      "drops this '{}'; it is kept here",
                      rule.symbols.back().token));
    read_.rules.push_back(std::move(rule));
  }

  // token_1|2|3
  AuthorsWord WordAt(Span span) {
    const std::string_view text =
        source_.text().substr(span.begin, span.end - span.begin);
    const std::size_t mark = text.find('_');
    AuthorsWord word{text.substr(0, mark), span, {}};
    if (mark == std::string_view::npos) return word;
    for (std::size_t at = mark + 1; at <= text.size();) {
      const std::size_t end = std::min(text.find('|', at), text.size());
      const std::string_view number = text.substr(at, end - at);
      const Span place{span.begin + static_cast<std::uint32_t>(at),
                       span.begin + static_cast<std::uint32_t>(end)};
      const auto value = ParseNumber<double>(number);
      if (!value)
        reporter_.Report(
            Code::kNotAuthors, place,
            fmt::format("a number is expected behind '_' and '|', not '{}'",
                        number));
      if (!rounded_ && IsRounded(number)) rounded_ = place;
      word.parameters.push_back({value.value_or(0), place});
      at = end + 1;
    }
    return word;
  }

  const Source& source_;
  AuthorsText read_;
  Reporter reporter_;
  std::optional<Span> rounded_;  // the first number that was
};

}  // namespace

AuthorsText ReadAuthorsLines(const Source& source) {
  return LinesReader(source).Read();
}

}  // namespace plsc
