// One pass over the items of the header, in file order, before any rule is
// looked at: items may stand in any order, so a rule may use what is declared
// below it. Of several declarations of one thing the first counts and the
// others are reported with its place.
//
// What is wrong is declared all the same, as far as that makes sense: a state
// with an empty range is still a state. Otherwise one mistake would be reported
// again at every use. For the same reason nothing is missed in a file of which
// an item did not parse (is_incomplete), as that may be the item, and without a
// known alphabet there is none (nullptr), so that no symbol is held to a
// wrong one.
//
// Names are found by hashing, and reports end at kMaxReported: linear in the
// file, whatever is in it. A hostile file has 10^5 names and every one of them
// wrong.

#include "compiler/scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/limits.h"
#include "compiler/own_alphabet.h"
#include "grammar/reporter.h"
#include "grammar/suggest.h"

namespace plsc {

namespace {

struct SettingInfo {
  std::string_view name;
  int low;
  int high;
};

// By SettingKey; move_to_new has no range.
constexpr std::array<SettingInfo, ast::kSettingCount> kSettings = {{
    {"iterations", kMinIterations, kMaxIterations},
    {"max_modules", kMinModules, kMaxModules},
    {"move_to_new", 0, 0},
    {"max_terms", kMinLimit, kMaxLimit},
    {"max_rules", kMinLimit, kMaxLimit},
}};

class Declarer {
 public:
  explicit Declarer(const ast::File& file) : file_(file) {
    scope_.header.alphabet = nullptr;
  }

  Scope Declare() {
    for (const ast::Item& item : file_.items) {
      if (reporter_.is_full()) break;
      DeclareItem(item);
    }
    if (scope_.header.name.empty()) scope_.header.name = kUnnamed;
    FinishAlphabet();
    FinishAxiom();
    scope_.diagnostics = reporter_.Take();
    return std::move(scope_);
  }

 private:
  // Whether this is the first item of `slot`; else says where the first is.
  bool IsFirst(const ast::Item& item, Span* slot) {
    if (slot->end == 0) {
      *slot = item.span;
      return true;
    }
    const std::string_view word = file_.Text(item.keyword);
    reporter_
        .Report(Code::kRepeatedItem, item.span,
                fmt::format("'{}' is given twice", word))
        .WithLabel("again here")
        .WithOther(*slot, "first here");
    return false;
  }

  void DeclareItem(const ast::Item& item) {
    using enum ast::ItemKind;
    switch (item.kind) {
      case kGenotype:
        scope_.header.name = file_.Text(file_.genotypes[item.index].name);
        break;
      case kAlphabet:
        if (IsFirst(item, &alphabet_))
          DeclareAlphabetItem(file_.alphabets[item.index]);
        break;
      case kSense:
        DeclareSense(file_.senses[item.index]);
        break;
      case kLet:
        DeclareConstant(file_.lets[item.index]);
        break;
      case kAxiom:
        if (IsFirst(item, &axiom_)) axiom_name_ = file_.axioms[item.index].name;
        break;
      case kSetting: {
        const ast::Setting& setting = file_.settings[item.index];
        Span* const slot = &settings_[static_cast<std::size_t>(setting.key)];
        if (IsFirst(item, slot)) DeclareSetting(item, setting);
        break;
      }
      case kRule:
      case kEnvironment:
      case kTest:
        break;
    }
  }

  void DeclareAlphabetItem(const ast::Alphabet& declared) {
    const AlphabetPtr& built_in = PlasticodingAlphabet();
    const std::string_view name = file_.Text(declared.name);
    const bool is_built_in = name == built_in->name();
    if (declared.is_own && is_built_in) {
      reporter_
          .Report(Code::kUnknownAlphabet, declared.name,
                  "'plasticoding' is built in")
          .WithHelp("write 'alphabet plasticoding 1', or choose another name");
    } else if (declared.is_own) {
      OwnAlphabet own = DeclareAlphabet(file_, declared);
      for (Diagnostic& diagnostic : own.diagnostics)
        reporter_.Add(std::move(diagnostic));
      scope_.header.alphabet = std::move(own.alphabet);
    } else if (!is_built_in) {
      reporter_
          .Report(Code::kUnknownAlphabet, declared.name,
                  fmt::format("unknown alphabet '{}'", name))
          .WithLabel("the built-in alphabet is 'plasticoding 1'")
          .WithFix(declared.name, built_in->name());
    } else if (!declared.version.is_integer ||
               declared.version.number != built_in->version()) {
      reporter_.Report(
          Code::kUnknownAlphabetVersion, declared.version.span,
          fmt::format("this file needs alphabet plasticoding {}; this tool "
                      "knows 1",
                      file_.Text(declared.version.span)));
    } else {
      scope_.header.alphabet = built_in;
    }
  }

  // Whether no state has the name yet; else says where it was declared first.
  bool IsNewState(Span name) {
    if (scope_.header.states.size() == kMaxStates) {
      reporter_.Report(
          Code::kLimit, name,
          fmt::format("a genotype has at most {} states", kMaxStates));
      return false;
    }
    const auto known = scope_.FindState(file_.Text(name));
    if (!known) return true;
    reporter_
        .Report(Code::kRepeatedName, name,
                fmt::format("state '{}' is declared twice", file_.Text(name)))
        .WithOther(scope_.state_spans[static_cast<std::size_t>(*known)],
                   "first declared here");
    return false;
  }

  void DeclareSense(const ast::Sense& declared) {
    if (!IsNewState(declared.name)) return;
    State state;
    Ids ids;
    state.name = file_.Text(declared.name);
    switch (declared.type) {
      case ast::SenseType::kBool:
        break;
      case ast::SenseType::kReal:
        state.type = StateType::kReal;
        state.low = declared.bounds.low.number;
        state.high = declared.bounds.high.number;
        if (!(state.low < state.high))
          reporter_
              .Report(
                  Code::kWrongState,
                  {declared.bounds.low.span.begin,
                   declared.bounds.high.span.end},
                  fmt::format("the range of state '{}' is empty", state.name))
              .WithLabel("the lower bound must be less than the upper");
        break;
      case ast::SenseType::kEnum:
        state.type = StateType::kEnum;
        state.values = EnumValues(declared, &ids);
        break;
    }
    scope_.state_ids.emplace(file_.Text(declared.name),
                             static_cast<StateId>(scope_.header.states.size()));
    scope_.header.states.push_back(std::move(state));
    scope_.state_spans.push_back(declared.name);
    scope_.value_ids.push_back(std::move(ids));
  }

  using Ids = std::unordered_map<std::string_view, std::size_t>;

  std::vector<std::string> EnumValues(const ast::Sense& declared, Ids* ids) {
    std::vector<std::string> values;
    const auto spans = ast::Slice(file_.names, declared.values);
    if (spans.size() > kMaxSymbols) {
      reporter_.Report(
          Code::kLimit, spans[kMaxSymbols],
          fmt::format("a state has at most {} values", kMaxSymbols));
      // A state that is well formed, so that nothing else is said of it.
      return {"a", "b"};
    }
    for (const Span span : spans) {
      const std::string_view value = file_.Text(span);
      if (!ids->emplace(value, values.size()).second)
        reporter_.Report(Code::kWrongState, span,
                         fmt::format("value '{}' is listed twice", value));
      else
        values.emplace_back(value);
    }
    if (spans.size() < 2)
      reporter_
          .Report(Code::kWrongState, spans[0],
                  fmt::format("state '{}' has only one value",
                              file_.Text(declared.name)))
          .WithLabel("a state that cannot change needs no sense");
    return values;
  }

  void DeclareConstant(const ast::Let& declared) {
    const std::string_view name = file_.Text(declared.name);
    if (const Constant* known = scope_.FindConstant(name)) {
      reporter_
          .Report(Code::kRepeatedName, declared.name,
                  fmt::format("constant '{}' is declared twice", name))
          .WithOther(known->span, "first declared here");
      return;
    }
    if (scope_.constants.size() == kMaxSymbols) {
      reporter_.Report(
          Code::kLimit, declared.name,
          fmt::format("a file has at most {} constants", kMaxSymbols));
      return;
    }
    scope_.constant_ids.emplace(name, scope_.constants.size());
    scope_.constants.push_back({name, declared.name, declared.value.number,
                                declared.value.is_integer});
  }

  void DeclareSetting(const ast::Item& item, const ast::Setting& setting) {
    using enum ast::SettingKey;
    const SettingInfo& info = kSettings[static_cast<std::size_t>(setting.key)];
    if (setting.key == kMoveToNew) {
      const bool is_true = setting.value.kind == ast::Value::Kind::kTrue;
      if (!is_true && setting.value.kind != ast::Value::Kind::kFalse)
        reporter_.Report(Code::kWrongSetting, setting.value.span,
                         "move_to_new must be True or False");
      scope_.header.development.move_to_new = is_true;
      return;
    }
    const auto number = SettingNumber(setting.value, info);
    if (!number) return;
    if (setting.key == kIterations) {
      scope_.header.development.iterations = *number;
    } else if (setting.key == kMaxModules) {
      scope_.header.development.max_modules = *number;
    } else if (setting.key == kMaxTerms) {
      scope_.header.max_terms = *number;
      scope_.max_terms_span = item.span;
    } else {
      scope_.header.max_rules = *number;
      scope_.max_rules_span = item.span;
    }
  }

  std::optional<int> SettingNumber(const ast::Value& value,
                                   const SettingInfo& info) {
    if (value.kind != ast::Value::Kind::kNumber || !value.is_integer) {
      reporter_
          .Report(Code::kWrongSetting, value.span,
                  fmt::format("{} must be a whole number", info.name))
          .WithLabel(fmt::format("from {} to {}", info.low, info.high));
      return std::nullopt;
    }
    if (value.number < info.low || value.number > info.high) {
      reporter_.Report(
          Code::kWrongSetting, value.span,
          fmt::format("{} {} is outside {}..{}", info.name,
                      file_.Text(value.span), info.low, info.high));
      return std::nullopt;
    }
    return static_cast<int>(value.number);
  }

  void FinishAlphabet() {
    if (alphabet_.end != 0 || file_.is_incomplete) return;
    const std::uint32_t at = file_.version.end;
    reporter_
        .Report(Code::kMissingItem, {at, at},
                "this file does not say its alphabet")
        .WithHelp("add 'alphabet plasticoding 1'")
        .WithFix({at, at}, "\nalphabet plasticoding 1");
  }

  void FinishAxiom() {
    const AlphabetPtr& alphabet = scope_.header.alphabet;
    if (alphabet == nullptr) return;
    if (axiom_.end == 0) {
      // SymbolId 0 is C, the paper's axiom.
      if (alphabet->is_built_in() || file_.is_incomplete) return;
      reporter_
          .Report(Code::kMissingItem, alphabet_,
                  "a file with its own alphabet needs an axiom")
          .WithHelp(
              "add 'axiom NAME', the symbol that development starts from");
      return;
    }
    const std::string_view name = file_.Text(axiom_name_);
    const auto id = alphabet->Find(name);
    if (!id) {
      Diagnostic& diagnostic =
          reporter_.Report(Code::kUnknownSymbol, axiom_name_,
                           fmt::format("unknown symbol '{}' in alphabet '{}'",
                                       name, alphabet->name()));
      std::vector<std::string_view> known;
      for (const SymbolInfo& symbol : alphabet->symbols())
        known.push_back(symbol.name);
      AddSuggestion(name, known, &diagnostic);
      return;
    }
    if (alphabet->is_built_in() && *id != plasticoding::kC)
      reporter_
          .Report(Code::kWrongAxiom, axiom_name_,
                  fmt::format("the axiom must be C, not '{}'", name))
          .WithLabel("development starts from the core");
    else if (!(*alphabet)[*id].parameters.empty())
      reporter_
          .Report(Code::kWrongAxiom, axiom_name_,
                  fmt::format("the axiom '{}' has parameters", name))
          .WithLabel("an axiom is a symbol without parameters");
    scope_.header.axiom = *id;
  }

  const ast::File& file_;
  Scope scope_;
  Reporter reporter_;
  // The first item of each kind; empty while there is none.
  Span alphabet_;
  Span axiom_;
  Span axiom_name_;
  std::array<Span, ast::kSettingCount> settings_;
};

}  // namespace

std::optional<StateId> Scope::FindState(std::string_view name) const {
  const auto found = state_ids.find(name);
  if (found == state_ids.end()) return std::nullopt;
  return found->second;
}

const Constant* Scope::FindConstant(std::string_view name) const {
  const auto found = constant_ids.find(name);
  return found == constant_ids.end() ? nullptr : &constants[found->second];
}

std::optional<std::size_t> Scope::FindValue(StateId state,
                                            std::string_view name) const {
  const auto& ids = value_ids[static_cast<std::size_t>(state)];
  const auto found = ids.find(name);
  if (found == ids.end()) return std::nullopt;
  return found->second;
}

Scope Declare(const ast::File& file) {
  return Declarer(file).Declare();
}

}  // namespace plsc
