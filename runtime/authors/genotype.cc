// From the authors' symbols to a genotype that Verify accepts, in one of two
// ways of reading (repr, lines) that give the same values. What their texts
// leave out is filled in as their experiments had it and said in a warning,
// since a genotype without it would develop otherwise.
//
// Their export was made after the level season had joined active rules inside
// the genotype (decision 1). Such a tail can be recognised, as it repeats the
// later rules symbol by symbol, and is left out only if that is asked for: it
// may also be there by evolution.

#include "runtime/authors/genotype.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "compiler/limits.h"
#include "compiler/truth.h"
#include "compiler/verify.h"
#include "grammar/reporter.h"
#include "grammar/screen.h"

namespace plsc {

namespace {

namespace p = plasticoding;

// u and l of the paper's experiments, which Revolve has outside of its texts.
constexpr std::size_t kAuthorsMaxTerms = 2;
constexpr std::size_t kAuthorsMaxRules = 2;

bool IsSame(const AuthorsWord& a, const AuthorsWord& b) {
  return a.token == b.token &&
         std::equal(a.parameters.begin(), a.parameters.end(),
                    b.parameters.begin(), b.parameters.end(),
                    [](const WrittenNumber& x, const WrittenNumber& y) {
                      return x.value == y.value;
                    });
}

class Importer {
 public:
  Importer(AuthorsText read, const ImportOptions& options)
      : read_(std::move(read)), options_(options) {
    for (Diagnostic& problem : read_.problems)
      reporter_.Add(std::move(problem));
  }

  Result<Program> Import() {
    if (!reporter_.has_errors()) {
      FindJoined();
      for (const AuthorsRule& rule : read_.rules)
        if (!reporter_.is_full()) Add(rule);
      FindLimits();
    }
    Program program;
    if (!reporter_.has_errors()) {
      program = Assembled();
      // With ranges allowed it may complain of ranges.
      for (const std::string& broken :
           options_.allow_range ? std::vector<std::string>{} : Verify(program))
        reporter_.Report(Code::kNotAuthors, {}, broken);
    }
    const bool is_broken = reporter_.has_errors();
    std::vector<Diagnostic> problems = reporter_.Take();
    SortAndDropRepeated(&problems);
    if (is_broken) return problems;
    return {std::move(program), std::move(problems)};
  }

 private:
  // In the level season, where every condition is False, Revolve has put the
  // later active rules of a letter behind its first one, in the genotype.
  void FindJoined() {
    if (!read_.has_clauses) return;
    const std::vector<double> level(read_.states.size(), 0);
    std::map<std::string_view, std::vector<AuthorsRule*>> active;
    for (AuthorsRule& rule : read_.rules)
      if (ClauseHolds(rule.clause, level))
        active[rule.letter.token].push_back(&rule);
    for (const auto& [letter, rules] : active)
      if (rules.size() > 1) Unjoin(rules);
  }

  void Unjoin(const std::vector<AuthorsRule*>& active) {
    std::vector<AuthorsWord> behind;
    for (std::size_t i = 1; i < active.size(); ++i) {
      const auto& symbols = active[i]->symbols;
      const bool has_core = !symbols.empty() && symbols.front().token == "C";
      behind.insert(behind.end(), symbols.begin() + (has_core ? 1 : 0),
                    symbols.end());
    }
    AuthorsRule& first = *active.front();
    if (behind.empty() || first.symbols.size() <= behind.size()) return;
    const auto begin =
        first.symbols.end() - static_cast<std::ptrdiff_t>(behind.size());
    if (!std::equal(begin, first.symbols.end(), behind.begin(), IsSame)) return;
    Diagnostic& diagnostic = reporter_.Report(
        Code::kLost, begin->span,
        fmt::format("from here on, {} symbols are those of the next rule "
                    "of {}: Revolve joined them in the level season, "
                    "before it wrote this",
                    behind.size(), first.letter.token));
    if (options_.unjoin)
      diagnostic.label = "left out";
    else
      diagnostic.help =
          "with --unjoin they are left out, as before that season";
    if (options_.unjoin) first.symbols.erase(begin, first.symbols.end());
  }

  void Add(const AuthorsRule& from) {
    const AuthorsSymbol* letter = FindAuthorsSymbol(from.letter.token);
    const bool is_letter = letter != nullptr &&
                           (*PlasticodingAlphabet())[letter->id].is_replaceable;
    if (!is_letter) {
      reporter_.Report(
          Code::kNotReplaceable, from.letter.span,
          fmt::format("a letter that has rules (C, AJ1, AJ2, B, ST) is "
                      "expected, not '{}'",
                      from.letter.token));
      return;
    }
    const bool is_second =
        !read_.has_clauses && !letters_.insert(letter->id).second;
    if (is_second)
      reporter_.Report(
          Code::kNotAuthors, from.letter.span,
          fmt::format("one rule of '{}' is expected, and this is the "
                      "second",
                      from.letter.token));
    if (from.symbols.empty()) {
      reporter_.Report(
          Code::kLost, from.span,
          fmt::format("this rule of {} is empty, which replaces nothing; "
                      "it is left out",
                      from.letter.token));
      return;
    }
    Rule rule{letter->id, from.clause, {}};
    for (const AuthorsWord& word : from.symbols) {
      if (reporter_.is_full()) return;
      if (const auto symbol =
              ImportSymbol(word, options_.allow_range, &reporter_))
        rule.production.push_back(*symbol);
    }
    CheckCore(from, letter->id);
    rules_.push_back(std::move(rule));
  }

  void CheckCore(const AuthorsRule& from, SymbolId head) {
    for (std::size_t i = 0; i < from.symbols.size() && !reporter_.is_full();
         ++i) {
      const bool wants_core = head == p::kC && i == 0;
      if ((from.symbols[i].token == "C") == wants_core) continue;
      reporter_.Report(Code::kMisplacedCore, from.symbols[i].span,
                       wants_core
                           ? "a rule of C is expected to start with C"
                           : "C is expected at the start of rules of C only");
    }
  }

  // What Revolve's operators keep to: without clauses a letter has one rule;
  // else the paper's u and l, or what a run with more has left in the text.
  void FindLimits() {
    if (!read_.has_clauses) {
      max_rules_ = 1;
      return;
    }
    Most terms{kAuthorsMaxTerms, {}};
    Most rules{kAuthorsMaxRules, {}};
    std::map<std::string_view, std::size_t> counts;
    for (const AuthorsRule& rule : read_.rules) {
      terms.Take(rule.clause.terms.size(), rule.span);
      rules.Take(++counts[rule.letter.token], rule.span);
    }
    max_terms_ = Limit("terms in a clause", kAuthorsMaxTerms, terms);
    max_rules_ = Limit("rules of a letter", kAuthorsMaxRules, rules);
  }

  // The most that a text has of something, and where.
  struct Most {
    std::size_t count;
    Span span;
    void Take(std::size_t other, Span place) {
      if (other > count) *this = {other, place};
    }
  };

  std::optional<int> Limit(const char* what, std::size_t usual, Most most) {
    if (most.count > usual)
      reporter_.Report(
          Code::kLost, most.span,
          fmt::format("{} {} are more than the paper's {}: the limit of their "
                      "run is not in the text, and {} is written for it",
                      most.count, what, usual,
                      most.count > kMaxLimit ? "none" : "this number"));
    if (most.count > kMaxLimit) return std::nullopt;
    return static_cast<int>(most.count);
  }

  Program Assembled() const {
    Program program;
    Genotype& genotype = program.genotype;
    genotype.name = options_.name;
    for (const std::string& state : read_.states)
      genotype.states.push_back({state, StateType::kBool, 0, 0, {}});
    genotype.axiom = p::kC;
    genotype.max_terms = max_terms_;
    genotype.max_rules = max_rules_;
    genotype.rules = rules_;
    std::stable_sort(
        genotype.rules.begin(), genotype.rules.end(),
        [](const Rule& a, const Rule& b) { return a.head < b.head; });
    if (genotype.states.size() == 1)
      program.environments = {{"plane", {{0}}}, {"tilted5", {{1}}}};
    return program;
  }

  AuthorsText read_;
  Reporter reporter_;
  const ImportOptions& options_;
  std::set<SymbolId> letters_;
  std::vector<Rule> rules_;
  std::optional<int> max_terms_;
  std::optional<int> max_rules_;
};

}  // namespace

AuthorsFormat GuessAuthorsFormat(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n", TextBegin(text));
  const bool is_dictionary =
      first != std::string_view::npos && text[first] == '{';
  return is_dictionary ? AuthorsFormat::kRepr : AuthorsFormat::kLines;
}

Result<Program> ImportAuthorsGenotype(const Source& source,
                                      AuthorsFormat format,
                                      const ImportOptions& options) {
  // P5012 says that the text is what is wanted here.
  const auto problem = Screen(source);
  if (problem && problem->code != Code::kAuthorsGenotype) return *problem;
  AuthorsText read = format == AuthorsFormat::kRepr ? ReadAuthorsRepr(source)
                                                    : ReadAuthorsLines(source);
  return Importer(std::move(read), options).Import();
}

}  // namespace plsc
