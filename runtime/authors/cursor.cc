#include "runtime/authors/cursor.h"

#include <fmt/format.h>

#include <utility>

#include "grammar/number.h"
#include "grammar/shown_line.h"

namespace plsc {

namespace {

constexpr std::string_view kBlank = " \t\r\n";
// Of a word that is shown in a message.
constexpr std::size_t kShown = 20;

// What has quotes of its own needs no others.
std::string Quoted(std::string_view text) {
  const char* mark = text.find('\'') == std::string_view::npos ? "'" : "";
  return fmt::format("{}{}{}", mark, text, mark);
}

}  // namespace

void AuthorsCursor::SkipBlanks() {
  at_ = std::min(text_.find_first_not_of(kBlank, at_), text_.size());
}

bool AuthorsCursor::Take(std::string_view mark) {
  if (has_failed()) return false;
  SkipBlanks();
  if (text_.substr(at_, mark.size()) != mark) return false;
  at_ += mark.size();
  return true;
}

bool AuthorsCursor::Want(std::string_view mark, const char* meaning) {
  if (Take(mark)) return true;
  Fail({at(), at() + (is_at_end() ? 0U : 1U)},
       fmt::format("{} {}", Quoted(mark), meaning));
  return false;
}

std::optional<Span> AuthorsCursor::Until(std::string_view ends,
                                         const char* meaning) {
  if (has_failed()) return std::nullopt;
  const std::size_t end = text_.find_first_of(ends, at_);
  const Span found{at(),
                   static_cast<std::uint32_t>(std::min(end, text_.size()))};
  if (end == std::string_view::npos || end == at_) {
    Fail({at(), at() + (is_at_end() ? 0U : 1U)}, meaning);
    return std::nullopt;
  }
  at_ = end;
  return found;
}

std::optional<WrittenNumber> AuthorsCursor::Number() {
  if (has_failed()) return std::nullopt;
  SkipBlanks();
  const std::size_t end =
      std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
  const Span span{at(), static_cast<std::uint32_t>(end)};
  const auto value = ParseNumber<double>(Text(span));
  if (!value) {
    Fail(end == at_ ? Span{at(), at() + (is_at_end() ? 0U : 1U)} : span,
         "a number");
    return std::nullopt;
  }
  at_ = end;
  return WrittenNumber{*value, span};
}

void AuthorsCursor::Fail(Span span, std::string expected) {
  if (has_failed()) return;
  error_ =
      Diagnostic(Code::kNotAuthors, span,
                 fmt::format("{} is expected, not {}", expected, Found()))
          .WithNote(
              "this is read as a genotype of Revolve, the authors' program");
}

std::string AuthorsCursor::Found() const {
  if (is_at_end()) return "the end of the file";
  const std::size_t end = text_.find_first_of(" \t\r\n,]}>", at_ + 1);
  return Quoted(
      Printable(text_.substr(at_, std::min(end, text_.size()) - at_), kShown));
}

}  // namespace plsc
