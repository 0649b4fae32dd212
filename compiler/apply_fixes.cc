// Compile, make the fixes that diagnostics offer, compile again: a fix may
// uncover errors that the mended one hid, and fixes may be wrong guesses. In a
// round all fixes are made that do not touch each other, earlier ones first;
// those of one diagnostic together or not at all, since half of a change is
// another error.
//
// No fix is trusted. The best text so far is kept by the number of its errors,
// and only that is handed out, so that the result never has more errors than
// the source. First all fixes are made at once and more errors are put up with
// for some rounds, because what hides behind a broken item comes out only when
// it is mended. If that leads nowhere, fixes are tried one by one, so that a
// bad one cannot keep the good ones from being made.
//
// It ends because a text is never gone on from twice (fixes may undo each
// other) and by kMaxRounds. kMaxRounds compilations a path at most; real files
// need a few.

#include "compiler/apply_fixes.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace plsc {

namespace {

// Rounds of compiling: a round mends all that does not overlap, and each item
// reports one syntax error at most, so that real files need a few. The bound
// keeps fixes that undo each other from going on for ever.
constexpr int kMaxRounds = 50;

std::size_t CountErrors(const std::vector<Diagnostic>& diagnostics) {
  return static_cast<std::size_t>(std::count_if(
      diagnostics.begin(), diagnostics.end(),
      [](const Diagnostic& d) { return d.severity == Severity::kError; }));
}

// Places that changes were chosen for. Two changes cannot both be made where
// they overlap, nor where they begin: of two insertions the order would matter.
class Taken {
 public:
  bool Touches(Span span) const {
    const auto next = ends_.lower_bound(span.begin);
    if (next != ends_.end() &&
        (next->first == span.begin || next->first < span.end))
      return true;
    return next != ends_.begin() && std::prev(next)->second > span.begin;
  }
  void Add(Span span) {
    std::uint32_t& end = ends_[span.begin];
    end = std::max(end, span.end);
  }

 private:
  std::map<std::uint32_t, std::uint32_t> ends_;  // by begin
};

bool IsInText(const Fix& fix, const Source& source) {
  return fix.span.begin <= fix.span.end && fix.span.end <= source.text().size();
}

// Diagnostics by where their first change is.
std::vector<const Diagnostic*> Fixable(
    const std::vector<Diagnostic>& diagnostics) {
  std::vector<const Diagnostic*> fixable;
  for (const Diagnostic& diagnostic : diagnostics)
    if (!diagnostic.fixes.empty()) fixable.push_back(&diagnostic);
  std::stable_sort(fixable.begin(), fixable.end(),
                   [](const Diagnostic* a, const Diagnostic* b) {
                     return a->fixes[0].span.begin < b->fixes[0].span.begin;
                   });
  return fixable;
}

MadeFix Describe(const Fix& fix, const Diagnostic& diagnostic,
                 const Source& source) {
  // With several changes the note tells them.
  const bool has_note =
      diagnostic.fixes.size() == 1 && !diagnostic.notes.empty();
  return {source.PositionOf(fix.span.begin), diagnostic.code,
          std::string(source.text().substr(fix.span.begin,
                                           fix.span.end - fix.span.begin)),
          fix.replacement, has_note ? diagnostic.notes.front() : ""};
}

// One path of mending: each round goes on from the text of the last.
class Mender {
 public:
  Mender(const Source& source, const CompileOptions& options)
      : name_(source.name()), options_(options) {
    current_ = Compiled(std::string(source.text()), {});
    best_ = current_;
    seen_.insert(current_.text);
  }

  /// All fixes at once, and go on even if there are more errors meanwhile: a
  /// mended item may show what it hid, and that may be mended next.
  void MendTogether() {
    for (int round = 0; round < kMaxRounds; ++round) {
      const MendedText next = Step(current_, current_.remaining);
      if (next.made.size() == current_.made.size() ||
          !seen_.insert(next.text).second)
        return;
      current_ = next;
      Keep(current_);
    }
  }

  /// One diagnostic after the other; those that do not help are passed over.
  void MendOneByOne() {
    std::size_t passed_over = 0;
    for (int round = 0; round < kMaxRounds; ++round) {
      const auto fixable = Fixable(best_.remaining);
      if (passed_over >= fixable.size()) return;
      const MendedText next = Step(best_, {*fixable[passed_over]});
      const bool helps = seen_.insert(next.text).second && Keep(next);
      if (!helps) ++passed_over;
    }
  }

  const MendedText& best() const { return best_; }

 private:
  MendedText Compiled(std::string text, std::vector<MadeFix> made) const {
    const auto result = CompileAll(Source(name_, text), options_);
    return {std::move(text), std::move(made), result.diagnostics()};
  }

  MendedText Step(const MendedText& from,
                  const std::vector<Diagnostic>& diagnostics) const {
    MendedText applied = ApplyFixes(Source(name_, from.text), diagnostics);
    std::vector<MadeFix> made = from.made;
    std::move(applied.made.begin(), applied.made.end(),
              std::back_inserter(made));
    return Compiled(std::move(applied.text), std::move(made));
  }

  // Whether `next` is the best text so far.
  bool Keep(const MendedText& next) {
    // As many errors as before are an improvement, too: one was mended and
    // shows another that it had hidden.
    if (CountErrors(next.remaining) > CountErrors(best_.remaining))
      return false;
    best_ = next;
    return true;
  }

  std::string name_;
  CompileOptions options_;
  MendedText current_;
  MendedText best_;
  std::set<std::string> seen_;
};

}  // namespace

MendedText ApplyFixes(const Source& source,
                      const std::vector<Diagnostic>& diagnostics) {
  MendedText mended;
  std::vector<Fix> chosen;
  Taken taken;
  for (const Diagnostic* diagnostic : Fixable(diagnostics)) {
    const bool can_be_made =
        std::all_of(diagnostic->fixes.begin(), diagnostic->fixes.end(),
                    [&](const Fix& fix) {
                      return IsInText(fix, source) && !taken.Touches(fix.span);
                    });
    if (!can_be_made) continue;
    for (const Fix& fix : diagnostic->fixes) {
      chosen.push_back(fix);
      taken.Add(fix.span);
      mended.made.push_back(Describe(fix, *diagnostic, source));
    }
  }
  std::sort(chosen.begin(), chosen.end(), [](const Fix& a, const Fix& b) {
    return a.span.begin < b.span.begin;
  });
  std::uint32_t copied = 0;
  for (const Fix& fix : chosen) {
    mended.text += source.text().substr(copied, fix.span.begin - copied);
    mended.text += WithLineEndsOf(source.text(), fix.replacement);
    copied = fix.span.end;
  }
  mended.text += source.text().substr(copied);
  return mended;
}

MendedText MendText(const Source& source, const CompileOptions& options) {
  Mender together(source, options);
  together.MendTogether();
  if (!together.best().made.empty()) return together.best();
  // One fix that makes things worse must not keep the others from being made.
  Mender careful(source, options);
  careful.MendOneByOne();
  return careful.best();
}

}  // namespace plsc
