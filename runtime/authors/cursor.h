#pragma once

// Reading a text of the authors' program from left to right: marks, words,
// numbers, and the one error that ends it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "grammar/diagnostic.h"
#include "runtime/authors/symbols.h"

namespace plsc {

class AuthorsCursor {
 public:
  explicit AuthorsCursor(std::string_view text)
      : text_(text), at_(TextBegin(text)) {}

  std::uint32_t at() const { return static_cast<std::uint32_t>(at_); }
  bool is_at_end() const { return at_ == text_.size(); }
  char peek() const { return is_at_end() ? '\0' : text_[at_]; }
  std::string_view Text(Span span) const {
    return text_.substr(span.begin, span.end - span.begin);
  }

  void SkipBlanks();
  /// Whether `mark` stood there (blanks before it skipped), and was taken.
  bool Take(std::string_view mark);
  /// The same of what must stand there; remembers the error.
  bool Want(std::string_view mark, const char* meaning);
  /// Up to the first of `ends`, which stays; remembers an error if there is
  /// none.
  std::optional<Span> Until(std::string_view ends, const char* meaning);
  /// A number as Python writes it; remembers an error.
  std::optional<WrittenNumber> Number();

  bool has_failed() const { return error_.has_value(); }
  const std::optional<Diagnostic>& error() const { return error_; }
  /// Remembers the first error only.
  void Fail(Span span, std::string expected);

 private:
  std::string Found() const;

  std::string_view text_;
  std::size_t at_ = 0;
  std::optional<Diagnostic> error_;
};

}  // namespace plsc
