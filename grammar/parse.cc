#include "grammar/parse.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

#include "grammar/actions.h"
#include "grammar/fast_match.h"
#include "grammar/header_actions.h"
#include "grammar/messages.h"
#include "grammar/recover.h"
#include "grammar/screen.h"
#include "grammar/test_actions.h"

namespace plsc {

namespace {

using grammar::Builder;

constexpr double kLanguageVersion = 1;

template <typename Rule>
struct Control : grammar::FastMatch<Rule> {
  template <typename Input>
  [[noreturn]] static void raise(const Input& in, Builder& b) {
    b.Fail(grammar::kError<Rule>,
           static_cast<std::uint32_t>(in.current() - b.base));
  }
};

Diagnostic WrongVersion(const ast::File& file) {
  const Span number = file.version_number.span;
  return Diagnostic(
             Code::kNewerVersion, number,
             fmt::format("this file needs plsc language {}; this tool reads 1",
                         file.Text(number)))
      .WithHelp("use a newer plsc, or a file of language 1");
}

// One allocation a pool for texts as Print writes them, of which a symbol has
// some 30 bytes, an argument 40 and a rule 400; other texts let them grow.
void ReservePools(ast::File* file) {
  const std::size_t bytes = file->text.size();
  file->symbols.reserve(bytes / 24);
  file->arguments.reserve(bytes / 32);
  file->rules.reserve(bytes / 256);
  file->terms.reserve(bytes / 128);
  file->items.reserve(bytes / 256 + 16);  // and those of the header
}

}  // namespace

ParseResult Parse(const Source& source) {
  Builder b;
  b.file.text = source.text();
  if (auto problem = Screen(source)) {
    b.file.is_incomplete = true;
    return {std::move(b.file), {*std::move(problem)}};
  }
  b.base = b.file.text.data();
  ReservePools(&b.file);
  using Input = tao::pegtl::memory_input<tao::pegtl::tracking_mode::lazy>;
  Input in(b.file.text.data(), b.file.text.data() + b.file.text.size(), "");
  [[maybe_unused]] const bool matched =
      tao::pegtl::parse<grammar::file, grammar::Action, Control>(in, b);
  assert(matched && "the top level recovers from everything");

  // Another version's rules are not ours to judge.
  if (b.file.version.end > 0 &&
      b.file.version_number.number != kLanguageVersion) {
    b.file.is_incomplete = true;
    Diagnostic wrong = WrongVersion(b.file);
    return {std::move(b.file), {std::move(wrong)}};
  }
  return {std::move(b.file), b.reporter.Take()};
}

}  // namespace plsc
