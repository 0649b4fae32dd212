// One walk over the trees collects every name with what it names and where that
// is declared; definition, references, highlights, rename and colours are then
// questions to a sorted list. Scopes answer what they know (states, constants);
// the rest is looked up in tables of this section. A name in what several
// genotypes share is collected once a section and kept once: it may mean
// something else in each, and a client can show one answer.

#include "runtime/lsp/mentions.h"

#include <algorithm>
#include <unordered_map>

namespace plsc::lsp {

namespace {

using Places = std::unordered_map<std::string_view, Span>;

// Of one section.
class Collector {
 public:
  Collector(const Section& section, std::vector<Mention>* mentions)
      : section_(section), file_(section.file), mentions_(mentions) {
    for (const ast::Alphabet& alphabet : file_.alphabets)
      for (const auto& symbol :
           Slice(file_.declarations, alphabet.declarations))
        symbols_.emplace(file_.Text(symbol.name), symbol.name);
    for (const ast::Environment& environment : file_.environments)
      environments_.emplace(file_.Text(environment.name), environment.name);
    for (const ast::Sense& sense : file_.senses)
      for (const Span value : Slice(file_.names, sense.values))
        values_[file_.Text(sense.name)].emplace(file_.Text(value), value);
  }

  void Collect() {
    using enum ast::ItemKind;
    for (const ast::Item& item : file_.items) {
      switch (item.kind) {
        case kGenotype:
          Declare(file_.genotypes[item.index].name, NameKind::kGenotype);
          break;
        case kAlphabet:
          AddAlphabet(file_.alphabets[item.index]);
          break;
        case kSense:
          AddSense(file_.senses[item.index]);
          break;
        case kLet:
          AddConstant(file_.lets[item.index].name);
          break;
        case kAxiom:
          AddSymbol(file_.axioms[item.index].name);
          break;
        case kSetting:
          break;
        case kRule:
          AddRule(file_.rules[item.index]);
          break;
        case kEnvironment:
          AddEnvironment(file_.environments[item.index]);
          break;
        case kTest:
          AddTest(file_.tests[item.index]);
          break;
      }
    }
  }

 private:
  Mention& Add(Span span, NameKind kind, Span declaration) {
    Mention mention;
    mention.span = span;
    mention.kind = kind;
    mention.declaration = declaration;
    mention.name = file_.Text(span);
    return mentions_->emplace_back(mention);
  }

  void Declare(Span name, NameKind kind) { Add(name, kind, name); }

  void AddState(Span name) {
    const auto id = section_.scope.FindState(file_.Text(name));
    Add(name, NameKind::kState,
        id ? section_.scope.state_spans[static_cast<std::size_t>(*id)]
           : Span{});
  }

  void AddConstant(Span name) {
    const Constant* constant = section_.scope.FindConstant(file_.Text(name));
    Add(name, NameKind::kConstant,
        constant == nullptr ? Span{} : constant->span);
  }

  void AddSymbol(Span name) {
    const auto place = symbols_.find(file_.Text(name));
    Mention& mention = Add(name, NameKind::kSymbol,
                           place == symbols_.end() ? Span{} : place->second);
    const AlphabetPtr& alphabet = section_.scope.header.alphabet;
    if (alphabet == nullptr) return;
    const auto id = alphabet->Find(mention.name);
    if (!id) return;
    mention.is_module = (*alphabet)[*id].is_replaceable;
    mention.is_built_in = alphabet->is_built_in();
  }

  void AddAlphabet(const ast::Alphabet& alphabet) {
    Add(alphabet.name, NameKind::kAlphabet,
        alphabet.is_own ? alphabet.name : Span{})
        .is_built_in = !alphabet.is_own;
    for (const auto& symbol :
         Slice(file_.declarations, alphabet.declarations)) {
      AddSymbol(symbol.name);
      for (const auto& parameter : Slice(file_.parameters, symbol.parameters))
        Declare(parameter.name, NameKind::kParameter);
    }
  }

  void AddSense(const ast::Sense& sense) {
    AddState(sense.name);
    for (const Span value : Slice(file_.names, sense.values))
      AddNamedValue(sense.name, value);
  }

  void AddNamedValue(Span state, Span value) {
    const auto values = values_.find(file_.Text(state));
    Span declaration;
    if (values != values_.end()) {
      const auto found = values->second.find(file_.Text(value));
      if (found != values->second.end()) declaration = found->second;
    }
    Add(value, NameKind::kValue, declaration);
  }

  // What a state is compared with, or has in an environment.
  void AddValueOf(Span state, const ast::Value& value) {
    AddState(state);
    if (value.kind != ast::Value::Kind::kName) return;
    const auto id = section_.scope.FindState(file_.Text(state));
    if (!id) return;
    const auto index = static_cast<std::size_t>(*id);
    if (section_.scope.header.states[index].type == StateType::kEnum)
      AddNamedValue(state, value.span);
    else
      AddConstant(value.span);
  }

  void AddSymbols(ast::Range symbols) {
    for (const ast::Symbol& symbol : Slice(file_.symbols, symbols)) {
      AddSymbol(symbol.name);
      for (const auto& argument : Slice(file_.arguments, symbol.arguments))
        if (argument.kind == ast::Value::Kind::kName)
          AddConstant(argument.span);
    }
  }

  void AddRule(const ast::Rule& rule) {
    AddSymbol(rule.head);
    mentions_->back().is_head = true;
    for (const ast::Term& term : Slice(file_.terms, rule.terms))
      AddValueOf(term.state, term.value);
    AddSymbols(rule.symbols);
  }

  void AddEnvironment(const ast::Environment& environment) {
    Declare(environment.name, NameKind::kEnvironment);
    for (const ast::Entry& entry : Slice(file_.entries, environment.entries))
      AddValueOf(entry.state, entry.value);
  }

  void AddTest(const ast::Test& test) {
    Declare(test.name, NameKind::kTest);
    if (test.environment.end > 0) {
      const auto place = environments_.find(file_.Text(test.environment));
      Add(test.environment, NameKind::kEnvironment,
          place == environments_.end() ? Span{} : place->second);
    }
    AddSymbols(test.symbols);
    for (const ast::BodyNode& node : Slice(file_.nodes, test.nodes)) {
      if (node.depth > 0)
        Add(node.face, NameKind::kFace, {}).is_built_in = true;
      AddSymbol(node.name);
    }
  }

  const Section& section_;
  const ast::File& file_;
  std::vector<Mention>* mentions_;
  Places symbols_;
  Places environments_;
  std::unordered_map<std::string_view, Places> values_;
};

}  // namespace

bool NameTheSame(const Mention& a, const Mention& b) {
  return a.kind == b.kind && a.declaration == b.declaration && a.name == b.name;
}

std::vector<Mention> MentionsOf(const std::vector<Section>& sections) {
  std::vector<Mention> mentions;
  for (const Section& section : sections)
    Collector(section, &mentions).Collect();
  std::stable_sort(mentions.begin(), mentions.end(),
                   [](const Mention& a, const Mention& b) {
                     return a.span.begin < b.span.begin;
                   });
  // The first: a name in what genotypes share may mean something else in each,
  // and one answer is all that a client can show.
  const auto end = std::unique(mentions.begin(), mentions.end(),
                               [](const Mention& a, const Mention& b) {
                                 return a.span.begin == b.span.begin;
                               });
  mentions.erase(end, mentions.end());
  return mentions;
}

}  // namespace plsc::lsp
