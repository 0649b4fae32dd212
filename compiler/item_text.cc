// The canonical spelling of each kind of item, piece by piece from the bytes of
// the file: numbers and names are copied as they were written, since "0.50" may
// be how its writer counts. What can stand on a line of its own is an element,
// with the bytes that it was made of, so that layout.cc knows which comments
// belong before it.

#include "compiler/item_text.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace plsc {

namespace {

std::string Name(const ast::File& file, Span span) {
  return std::string(file.Text(span));
}

std::string RangeOf(const ast::File& file, const ast::Bounds& bounds) {
  return Name(file, bounds.low.span) + ".." + Name(file, bounds.high.span);
}

std::string SymbolText(const ast::File& file, const ast::Symbol& symbol) {
  std::string text = Name(file, symbol.name);
  if (symbol.arguments.count == 0) return text;
  text += '(';
  bool is_first = true;
  for (const ast::Value& value : ast::Slice(file.arguments, symbol.arguments)) {
    if (!is_first) text += ", ";
    is_first = false;
    text += file.Text(value.span);
  }
  return text + ')';
}

std::string ClauseText(const ast::File& file, const ast::Rule& rule) {
  std::string text;
  for (const ast::Term& term : ast::Slice(file.terms, rule.terms)) {
    if (term.connective == ast::Connective::kAnd) text += " and ";
    if (term.connective == ast::Connective::kOr) text += " or ";
    text += file.Text(term.state);
    text += ' ';
    text += file.Text(term.comparison_span);
    text += ' ';
    // Values that were corrected are errors, so the spelling is right.
    text += file.Text(term.value.span);
  }
  return text;
}

ItemText RuleText(const ast::File& file, const ast::Rule& rule) {
  ItemText text;
  text.open = "rule " + Name(file, rule.head) + " -> ";
  if (rule.terms.count > 0)
    text.open += "if " + ClauseText(file, rule) + " then ";
  text.open += '{';
  for (const ast::Symbol& symbol : ast::Slice(file.symbols, rule.symbols))
    text.elements.push_back({symbol.span, SymbolText(file, symbol)});
  return text;
}

std::string DeclarationText(const ast::File& file,
                            const ast::Declaration& declared) {
  std::string text = Name(file, declared.name);
  if (declared.parameters.count == 0) return text;
  text += '(';
  bool is_first = true;
  for (const ast::Parameter& parameter :
       ast::Slice(file.parameters, declared.parameters)) {
    if (!is_first) text += ", ";
    is_first = false;
    text += file.Text(parameter.name);
    text += parameter.is_integer ? ": int" : ": real";
    if (parameter.bounds.is_present)
      text += " in " + RangeOf(file, parameter.bounds);
  }
  return text + ')';
}

ItemText AlphabetText(const ast::File& file, const ast::Alphabet& alphabet,
                      bool has_comments) {
  ItemText text;
  text.open = "alphabet " + Name(file, alphabet.name) + " ";
  if (!alphabet.is_own) {
    text.open += file.Text(alphabet.version.span);
    return text;
  }
  text.open += '{';
  const ast::Declaration* last = nullptr;
  for (const ast::Declaration& declared :
       ast::Slice(file.declarations, alphabet.declarations)) {
    const std::string declaration = DeclarationText(file, declared);
    const bool is_new_group = last == nullptr || has_comments ||
                              last->is_replaceable != declared.is_replaceable;
    if (is_new_group) {
      if (last != nullptr) text.elements.back().text += ';';
      const char* const word =
          declared.is_replaceable ? "replaceable " : "terminal ";
      text.elements.push_back({declared.span, word + declaration});
    } else {
      text.elements.back().text += ", " + declaration;
      text.elements.back().span.end = declared.span.end;
    }
    last = &declared;
  }
  return text;
}

ItemText EnvironmentText(const ast::File& file,
                         const ast::Environment& environment,
                         bool has_comments) {
  ItemText text;
  text.open = "environment " + Name(file, environment.name) + " {";
  std::string line;
  for (const ast::Entry& entry :
       ast::Slice(file.entries, environment.entries)) {
    std::string one =
        Name(file, entry.state) + " = " + Name(file, entry.value.span);
    line += (line.empty() ? " " : ", ") + one;
    if (!text.elements.empty()) text.elements.back().text += ',';
    text.elements.push_back({entry.span, std::move(one)});
  }
  if (has_comments) return text;
  text.open += line + (line.empty() ? "}" : " }");
  text.elements.clear();
  return text;
}

std::string HeadOf(const ast::File& file, const ast::Test& test) {
  std::string text = "test " + Name(file, test.name);
  if (test.environment.end > 0) text += " in " + Name(file, test.environment);
  if (test.has_after) text += " after " + Name(file, test.after.span);
  return text + " -> ";
}

// A module a line, indented by its depth in the tree.
ItemText BodyTestText(const ast::File& file, const ast::Test& test) {
  ItemText text;
  const auto nodes = ast::Slice(file.nodes, test.nodes);
  const bool has_children = nodes[0].open.end > 0;
  text.open = HeadOf(file, test) + "body " + Name(file, nodes[0].name) +
              (has_children ? " {" : "");
  std::vector<Span> open;  // braces that will close, the first's left out
  const auto indent = [&] { return std::string(2 * open.size(), ' '); };
  const auto close_to = [&](std::size_t depth) {
    while (open.size() > depth) {
      const Span brace = open.back();
      open.pop_back();
      text.elements.push_back({brace, indent() + "}"});
    }
  };
  for (const ast::BodyNode& node : nodes.subspan(1)) {
    close_to(node.depth - 1);
    const bool is_parent = node.open.end > 0;
    text.elements.push_back(
        {{node.face.begin, is_parent ? node.open.end : node.name.end},
         indent() + Name(file, node.face) + " " + Name(file, node.name) +
             (is_parent ? " {" : "")});
    if (is_parent) open.push_back(node.close);
  }
  close_to(0);
  return text;
}

ItemText TestText(const ast::File& file, const ast::Test& test) {
  if (test.nodes.count > 0) return BodyTestText(file, test);
  ItemText text;
  text.open = HeadOf(file, test) + "{";
  for (const ast::Symbol& symbol : ast::Slice(file.symbols, test.symbols))
    text.elements.push_back({symbol.span, SymbolText(file, symbol)});
  return text;
}

std::string SenseText(const ast::File& file, const ast::Sense& sense) {
  std::string text = "sense " + Name(file, sense.name) + ": ";
  switch (sense.type) {
    case ast::SenseType::kBool:
      return text + "bool";
    case ast::SenseType::kReal:
      return text + "real in " + RangeOf(file, sense.bounds);
    case ast::SenseType::kEnum:
      break;
  }
  bool is_first = true;
  for (const Span value : ast::Slice(file.names, sense.values)) {
    text += is_first ? "{ " : ", ";
    is_first = false;
    text += file.Text(value);
  }
  return text + " }";
}

std::string OneLineText(const ast::File& file, const ast::Item& item) {
  const std::string keyword = Name(file, item.keyword) + " ";
  switch (item.kind) {
    case ast::ItemKind::kGenotype:
      return keyword + Name(file, file.genotypes[item.index].name);
    case ast::ItemKind::kAxiom:
      return keyword + Name(file, file.axioms[item.index].name);
    case ast::ItemKind::kSetting:
      return keyword + Name(file, file.settings[item.index].value.span);
    case ast::ItemKind::kLet: {
      const ast::Let& let = file.lets[item.index];
      return keyword + Name(file, let.name) + " = " +
             Name(file, let.value.span);
    }
    default:
      return SenseText(file, file.senses[item.index]);
  }
}

}  // namespace

Span BracesOf(const ast::File& file, const ast::Item& item) {
  switch (item.kind) {
    case ast::ItemKind::kRule: {
      const ast::Rule& rule = file.rules[item.index];
      return {rule.open.begin, rule.close.end};
    }
    case ast::ItemKind::kAlphabet: {
      const ast::Alphabet& alphabet = file.alphabets[item.index];
      if (!alphabet.is_own) return {};
      return {alphabet.open.begin, alphabet.close.end};
    }
    case ast::ItemKind::kEnvironment: {
      const ast::Environment& environment = file.environments[item.index];
      return {environment.open.begin, environment.close.end};
    }
    case ast::ItemKind::kTest: {
      const ast::Test& test = file.tests[item.index];
      return {test.open.begin, test.close.end};
    }
    default:
      return {};
  }
}

ItemText TextOf(const ast::File& file, const ast::Item& item,
                bool has_comments) {
  ItemText text;
  switch (item.kind) {
    case ast::ItemKind::kRule:
      text = RuleText(file, file.rules[item.index]);
      break;
    case ast::ItemKind::kAlphabet:
      text = AlphabetText(file, file.alphabets[item.index], has_comments);
      break;
    case ast::ItemKind::kEnvironment:
      text = EnvironmentText(file, file.environments[item.index], has_comments);
      break;
    case ast::ItemKind::kTest:
      text = TestText(file, file.tests[item.index]);
      break;
    default:
      text.open = OneLineText(file, item);
      break;
  }
  text.braces = BracesOf(file, item);
  text.has_braces = text.open.ends_with('{');
  return text;
}

}  // namespace plsc
