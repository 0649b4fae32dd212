#include "runtime/lsp/completion.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "grammar/number.h"
#include "runtime/lsp/chosen_environment.h"
#include "runtime/lsp/completion_context.h"
#include "runtime/lsp/descriptions.h"
#include "runtime/lsp/keyword_docs.h"
#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

// LSP's CompletionItemKind.
enum class ItemKind : int {
  kFunction = 3,
  kVariable = 6,
  kClass = 7,
  kProperty = 10,
  kKeyword = 14,
  kEnumMember = 20,
  kConstant = 21,
  kStruct = 22,
  kOperator = 24,
};
constexpr int kSnippetFormat = 2;

struct Template {
  const char* word;
  const char* snippet;
};

// Items as people mostly write them.
constexpr std::array<Template, 13> kItems = {{
    {"alphabet", "alphabet plasticoding 1"},
    {"axiom", "axiom ${1:C}"},
    {"environment", "environment ${1:name} { $0 }"},
    {"genotype", "genotype ${1:name}"},
    {"iterations", "iterations ${1:3}"},
    {"let", "let ${1:name} = ${2:0.5}"},
    {"max_modules", "max_modules ${1:15}"},
    {"max_rules", "max_rules ${1:2}"},
    {"max_terms", "max_terms ${1:2}"},
    {"move_to_new", "move_to_new ${1|True,False|}"},
    {"rule", "rule ${1:B} -> if ${2:clause} then {\n  $0\n}"},
    {"sense", "sense ${1:name}: ${2:bool}"},
    {"test", "test ${1:name} in ${2:environment} -> { $0 }"},
}};

// An argument that is right and easy to change.
double Example(const Parameter& parameter) {
  if (std::isfinite(parameter.low) && std::isfinite(parameter.high))
    return (parameter.low + parameter.high) / 2;
  return std::isfinite(parameter.low) ? parameter.low : 0;
}

std::string SymbolSnippet(const SymbolInfo& symbol) {
  std::string text = symbol.name;
  int place = 0;
  for (const Parameter& parameter : symbol.parameters) {
    ++place;
    const double example = Example(parameter);
    text += fmt::format(
        "{}${{{}:{}}}", place == 1 ? "(" : ", ", place,
        PrintNumber(parameter.is_integer ? std::floor(example) : example));
  }
  return place == 0 ? text : text + ")";
}

class Completer {
 public:
  Completer(Analysis& analysis, const CompletionContext& context,
            bool has_snippets)
      : section_(analysis.SectionAt(context.word.begin)),
        lines_(analysis.lines()),
        context_(context),
        has_snippets_(has_snippets) {}

  Json Complete() {
    using enum Wanted;
    switch (context_.wanted) {
      case kNothing:
        break;
      case kItem:
        for (const Template& item : kItems) AddItem(item);
        break;
      case kHead:
        AddSymbols([](const SymbolInfo& s) { return s.is_replaceable; });
        break;
      case kAxiom:
        AddSymbols([](const SymbolInfo& s) { return s.parameters.empty(); });
        break;
      case kSymbol:
        AddSymbols([](const SymbolInfo&) { return true; });
        break;
      case kModule:
        AddSymbols([](const SymbolInfo& s) {
          return s.category == Category::kModule;
        });
        break;
      case kConstant:
        AddConstants();
        break;
      case kState:
      case kEntry:
        AddStates();
        break;
      case kComparison:
        AddComparisons();
        break;
      case kValue:
        AddValues();
        break;
      case kEnvironment:
        AddEnvironments();
        break;
      default:
        AddWords();
        break;
    }
    return std::move(items_);
  }

 private:
  Json& Add(std::string_view label, ItemKind kind, std::string doc) {
    Json item = {{"label", std::string(label)},
                 {"kind", static_cast<int>(kind)}};
    if (!doc.empty()) item["documentation"] = MarkdownJson(std::move(doc));
    item["textEdit"] = TextEditJson(lines_, context_.word, std::string(label));
    return items_.emplace_back(std::move(item));
  }

  void SetSnippet(const std::string& snippet, Json* item) {
    if (!has_snippets_) return;
    (*item)["insertTextFormat"] = kSnippetFormat;
    (*item)["textEdit"]["newText"] = snippet;
  }

  void AddItem(const Template& item) {
    Json& added =
        Add(item.word, ItemKind::kKeyword, std::string(KeywordDoc(item.word)));
    SetSnippet(item.snippet, &added);
  }

  template <typename Predicate>
  void AddSymbols(Predicate is_wanted) {
    const AlphabetPtr& alphabet = section_.scope.header.alphabet;
    if (alphabet == nullptr) return;
    // Arguments belong to productions only.
    const bool takes_arguments = context_.wanted == Wanted::kSymbol;
    for (const SymbolInfo& symbol : alphabet->symbols()) {
      if (!is_wanted(symbol)) continue;
      Json& item =
          Add(symbol.name,
              symbol.is_replaceable ? ItemKind::kClass : ItemKind::kFunction,
              DescribeSymbol(symbol));
      item["detail"] = SignatureOf(symbol);
      if (takes_arguments && !symbol.parameters.empty())
        SetSnippet(SymbolSnippet(symbol), &item);
    }
  }

  void AddConstants() {
    for (const Constant& constant : section_.scope.constants)
      Add(constant.name, ItemKind::kConstant, "")["detail"] =
          PrintNumber(constant.value);
  }

  void AddStates() {
    const std::unordered_set<std::string_view> given(context_.given.begin(),
                                                     context_.given.end());
    for (const State& state : section_.scope.header.states)
      if (!given.contains(state.name))
        Add(state.name, ItemKind::kVariable, DescribeState(state));
  }

  const State* Subject() const {
    const auto id = section_.scope.FindState(context_.subject);
    if (!id) return nullptr;
    return &section_.scope.header.StateOf(*id);
  }

  void AddComparisons() {
    const State* state = Subject();
    for (const char* name : {"=", "!="}) Add(name, ItemKind::kOperator, "");
    if (state != nullptr && state->type != StateType::kReal) return;
    for (const char* name : {"<", "<=", ">", ">="})
      Add(name, ItemKind::kOperator, "");
  }

  void AddValues() {
    const State* state = Subject();
    if (state == nullptr) return;
    switch (state->type) {
      case StateType::kBool:
        for (const char* value : {"True", "False"})
          Add(value, ItemKind::kEnumMember, "");
        break;
      case StateType::kReal:
        AddConstants();
        break;
      case StateType::kEnum:
        for (const std::string& value : state->values)
          Add(value, ItemKind::kEnumMember, "");
        break;
    }
  }

  void AddEnvironments() {
    const std::vector<State>& states = section_.scope.header.states;
    for (const NamedEnvironment& one : EnvironmentsOf(section_))
      Add(one.name, ItemKind::kStruct, DescribeEnvironment(one, states));
  }

  // Fixed words.
  void AddWords() {
    struct Words {
      Wanted wanted;
      std::array<const char*, 4> words;  // nullptr: no more
    };
    static constexpr std::array<Words, 9> kWords = {{
        {Wanted::kClauseOrBrace, {"if", "{"}},
        {Wanted::kConnective, {"and", "or", "then"}},
        {Wanted::kBrace, {"{"}},
        {Wanted::kType, {"bool", "real in"}},
        {Wanted::kAlphabet, {"plasticoding 1"}},
        {Wanted::kTruth, {"True", "False"}},
        {Wanted::kTestWord, {"in", "after", "->"}},
        {Wanted::kExpectation, {"{", "body"}},
        {Wanted::kFace, {"front", "left", "right", "back"}},
    }};
    for (const Words& words : kWords)
      for (const char* word : words.words)
        if (words.wanted == context_.wanted && word != nullptr)
          Add(word, ItemKind::kKeyword, std::string(KeywordDoc(word)));
  }

  const Section& section_;
  const LineTable& lines_;
  const CompletionContext& context_;
  bool has_snippets_;
  Json items_ = Json::array();
};

}  // namespace

Json Completion(Analysis& analysis, std::uint32_t offset, bool has_snippets) {
  const CompletionContext context = ContextAt(analysis.text(), offset);
  return Completer(analysis, context, has_snippets).Complete();
}

}  // namespace plsc::lsp
