#include "grammar/ebnf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

namespace plsc::testing {

namespace {

using Kind = Ebnf::Kind;

// The page's width; the repository's own.
constexpr std::size_t kColumns = 80;

class Printer {
 public:
  explicit Printer(const EbnfGrammar& grammar) : grammar_(grammar) {}

  std::string Print() {
    lexical_.insert(grammar_.lexical.begin(), grammar_.lexical.end());
    List(grammar_.start);
    for (const std::string& key : grammar_.lexical) List(key);
    std::size_t width = 0;
    for (const auto& [name, body] : listed_)
      width = std::max(width, name.size());
    std::string text;
    for (const auto& [name, body] : listed_)
      text += Paragraph(fmt::format("{:{}} =", name, width), Tokens(body));
    return text;
  }

 private:
  // Adds the rule and, in the order in which it names them, those it needs.
  void List(const std::string& key) {
    if (!seen_.insert(key).second) return;
    const Ebnf body = Simplified(grammar_.rules.at(key).body);
    listed_.emplace_back(NameOf(key), body);
    ListRulesOf(body);
  }
  void ListRulesOf(const Ebnf& part) {
    if (part.kind == Kind::kRule && lexical_.count(part.text) == 0)
      List(part.text);
    for (const Ebnf& inner : part.parts) ListRulesOf(inner);
  }

  std::string NameOf(const std::string& key) const {
    const std::vector<std::string>& names = grammar_.rules.at(key).names;
    for (const std::string& name : names) {
      const auto given = grammar_.names.find(name);
      if (given != grammar_.names.end()) return given->second;
    }
    return *std::min_element(names.begin(), names.end(),
                             [](const std::string& a, const std::string& b) {
                               return a.size() < b.size();
                             });
  }

  // Whether a rule of this (simplified) body needs no line of its own.
  bool IsInline(const std::string& key, const Ebnf& body) const {
    return body.kind == Kind::kEmpty || body.kind == Kind::kTerminal ||
           body.kind == Kind::kRule || NameOf(key).ends_with("_word");
  }

  Ebnf Simplified(const Ebnf& ebnf) {
    if (ebnf.kind == Kind::kRule) return SimplifiedRule(ebnf);
    Ebnf result = ebnf;
    result.parts.clear();
    for (const Ebnf& part : ebnf.parts) {
      Ebnf simple = Simplified(part);
      if (simple.kind == Kind::kEmpty) continue;
      if (simple.kind == ebnf.kind)  // nested sequences and choices are one
        result.parts.insert(result.parts.end(), simple.parts.begin(),
                            simple.parts.end());
      else
        result.parts.push_back(std::move(simple));
    }
    if (ebnf.kind == Kind::kTerminal) return result;
    if (result.parts.empty()) return {};
    const bool is_list =
        ebnf.kind == Kind::kSequence || ebnf.kind == Kind::kChoice;
    if (is_list && result.parts.size() == 1) return Ebnf(result.parts.front());
    return result;
  }

  Ebnf SimplifiedRule(const Ebnf& ebnf) {
    // A rule that contains itself stays a rule.
    const bool is_lexical = lexical_.count(ebnf.text) > 0;
    if (is_lexical || !open_.insert(ebnf.text).second) return ebnf;
    const Ebnf body = Simplified(grammar_.rules.at(ebnf.text).body);
    open_.erase(ebnf.text);
    return IsInline(ebnf.text, body) ? body : ebnf;
  }

  // What must not be broken across lines, in order.
  std::vector<std::string> Tokens(const Ebnf& ebnf) const {
    switch (ebnf.kind) {
      case Kind::kEmpty:
        return {};
      case Kind::kTerminal:
        return {ebnf.text};
      case Kind::kRule:
        return {NameOf(ebnf.text)};
      case Kind::kSequence:
        return Joined(ebnf, "", Kind::kChoice);
      case Kind::kChoice:
        return Joined(ebnf, "|", Kind::kChoice);
      case Kind::kRepeat:
        return Enclosed("{", Tokens(ebnf.parts.front()), "}");
      case Kind::kOptional:
        return Enclosed("[", Tokens(ebnf.parts.front()), "]");
    }
    return {};
  }
  std::vector<std::string> Joined(const Ebnf& ebnf,
                                  const std::string& separator,
                                  Kind needs_parentheses) const {
    std::vector<std::string> tokens;
    for (const Ebnf& part : ebnf.parts) {
      if (!tokens.empty() && !separator.empty()) tokens.push_back(separator);
      std::vector<std::string> inner = Tokens(part);
      if (part.kind == needs_parentheses)
        inner = Enclosed("(", std::move(inner), ")");
      tokens.insert(tokens.end(), inner.begin(), inner.end());
    }
    return tokens;
  }
  static std::vector<std::string> Enclosed(std::string open,
                                           std::vector<std::string> tokens,
                                           std::string close) {
    tokens.insert(tokens.begin(), std::move(open));
    tokens.push_back(std::move(close));
    return tokens;
  }

  // Lines break only where they stay readable: not behind what opens or
  // separates, and not before what closes.
  static std::vector<std::string> Unbreakable(
      const std::vector<std::string>& tokens) {
    static const std::set<std::string> with_next = {"{", "[", "(", "|"};
    static const std::set<std::string> with_previous = {"}", "]", ")", ";"};
    std::vector<std::string> pieces;
    bool is_joined = false;
    for (const std::string& token : tokens) {
      if (!pieces.empty() && (is_joined || with_previous.count(token) > 0))
        pieces.back() += " " + token;
      else
        pieces.push_back(token);
      is_joined = with_next.count(token) > 0;
    }
    return pieces;
  }

  static std::string Paragraph(const std::string& head,
                               std::vector<std::string> tokens) {
    tokens.emplace_back(";");
    std::string text;
    std::string line = head;
    for (const std::string& piece : Unbreakable(tokens)) {
      if (line.size() + 1 + piece.size() > kColumns) {
        text += line + "\n";
        line = std::string(head.size(), ' ');
      }
      line += " " + piece;
    }
    return text + line + "\n";
  }

  const EbnfGrammar& grammar_;
  std::set<std::string> lexical_;
  std::set<std::string> seen_;
  std::set<std::string> open_;
  std::vector<std::pair<std::string, Ebnf>> listed_;
};

}  // namespace

std::string PrintEbnf(const EbnfGrammar& grammar) {
  return Printer(grammar).Print();
}

}  // namespace plsc::testing
