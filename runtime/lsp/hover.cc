#include "runtime/lsp/hover.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "compiler/lower.h"
#include "grammar/keywords.h"
#include "grammar/number.h"
#include "runtime/lsp/chosen_environment.h"
#include "runtime/lsp/descriptions.h"
#include "runtime/lsp/keyword_docs.h"
#include "runtime/lsp/params.h"

namespace plsc::lsp {

namespace {

struct Found {
  Span span;
  std::string text;  ///< Markdown; empty: nothing to say
};

bool Covers(Span span, std::uint32_t offset) {
  return span.begin <= offset && offset <= span.end && span.end > 0;
}

// What `mention` names, in the section that it is in.
class Describer {
 public:
  Describer(const Section& section, const Mention& mention)
      : section_(section), mention_(mention) {}

  std::string Describe() const {
    using enum NameKind;
    switch (mention_.kind) {
      case kSymbol:
        return OfSymbol();
      case kState:
        return OfState();
      case kConstant:
        return OfConstant();
      case kEnvironment:
        return OfEnvironment();
      case kGenotype:
        return fmt::format("```pls\ngenotype {}\n```\n{} rules\n",
                           mention_.name, section_.file.rules.size());
      case kTest:
        return std::string(KeywordDoc("test"));
      case kAlphabet:
        return std::string(KeywordDoc("alphabet"));
      case kValue:
        return fmt::format("`{}`, a value of a state", mention_.name);
      case kParameter:
        return fmt::format("`{}`, a parameter of a symbol", mention_.name);
      case kFace:
        return fmt::format("the {} of the module around it", mention_.name);
    }
    return "";
  }

 private:
  std::string OfSymbol() const {
    const AlphabetPtr& alphabet = section_.scope.header.alphabet;
    const auto id =
        alphabet == nullptr ? std::nullopt : alphabet->Find(mention_.name);
    if (!id) return "";
    std::string text = DescribeSymbol((*alphabet)[*id]);
    const auto rules =
        std::count(section_.resolution.heads.begin(),
                   section_.resolution.heads.end(), std::optional(*id));
    if ((*alphabet)[*id].is_replaceable)
      text += fmt::format("\n{} rule{} here rewrite{} it\n", rules,
                          rules == 1 ? "" : "s", rules == 1 ? "s" : "");
    return text;
  }

  std::string OfState() const {
    const auto id = section_.scope.FindState(mention_.name);
    if (!id) return "";
    return DescribeState(section_.scope.header.StateOf(*id));
  }

  std::string OfConstant() const {
    const Constant* constant = section_.scope.FindConstant(mention_.name);
    if (constant == nullptr) return "";
    return fmt::format("```pls\nlet {} = {}\n```\n", constant->name,
                       PrintNumber(constant->value));
  }

  std::string OfEnvironment() const {
    for (const NamedEnvironment& one : EnvironmentsOf(section_))
      if (one.name == mention_.name)
        return DescribeEnvironment(one, section_.scope.header.states);
    return "";
  }

  const Section& section_;
  const Mention& mention_;
};

// The truth table of the clause around `offset`.
Found ClauseAt(const Section& section, std::uint32_t offset) {
  for (const ast::Rule& rule : section.file.rules) {
    if (rule.terms.count == 0 || !Covers(rule.clause, offset)) continue;
    for (std::uint32_t k = 0; k < rule.terms.count; ++k)
      if (!section.resolution.terms[rule.terms.first + k]) return {};
    return {rule.clause,
            TruthMarkdown(LowerClause(section.file, rule, section.resolution),
                          section.scope.header.states)};
  }
  return {};
}

// The parameter that the argument at `offset` is for.
Found ArgumentAt(const Section& section, std::uint32_t offset) {
  const ast::File& file = section.file;
  for (std::size_t i = 0; i < file.symbols.size(); ++i) {
    const ast::Symbol& symbol = file.symbols[i];
    const auto& id = section.resolution.symbols[i];
    if (!Covers(symbol.span, offset) || !id) continue;
    const SymbolInfo& info = section.scope.header.SymbolOf(*id);
    const auto arguments = Slice(file.arguments, symbol.arguments);
    for (std::size_t a = 0; a < arguments.size(); ++a)
      if (Covers(arguments[a].span, offset) && a < info.parameters.size())
        return {arguments[a].span,
                fmt::format("{} of `{}`\n",
                            DescribeParameter(info.parameters[a]), info.name)};
  }
  return {};
}

Found KeywordAt(std::string_view text, std::uint32_t offset) {
  auto begin = offset;
  auto end = offset;
  while (begin > 0 && IsWordCharacter(text[begin - 1])) --begin;
  while (end < text.size() && IsWordCharacter(text[end])) ++end;
  return {{begin, end},
          std::string(KeywordDoc(text.substr(begin, end - begin)))};
}

bool IsInComment(const ast::File& file, std::uint32_t offset) {
  return std::any_of(file.comments.begin(), file.comments.end(),
                     [&](Span comment) {
                       return comment.begin < offset && offset <= comment.end;
                     });
}

}  // namespace

Json Hover(Analysis& analysis, std::uint32_t offset) {
  if (IsInComment(analysis.file(), offset)) return nullptr;
  const Section& section = analysis.SectionAt(offset);
  Found found;
  if (const Mention* mention = analysis.MentionAt(offset))
    found = {mention->span, Describer(section, *mention).Describe()};
  for (Found (*look)(const Section&, std::uint32_t) : {ArgumentAt, ClauseAt}) {
    Found more = look(section, offset);
    if (more.text.empty()) continue;
    if (found.text.empty()) found.span = more.span;
    found.text += (found.text.empty() ? "" : "\n") + more.text;
  }
  if (found.text.empty()) found = KeywordAt(analysis.text(), offset);
  if (found.text.empty()) return nullptr;
  return {{"contents", MarkdownJson(std::move(found.text))},
          {"range", RangeJson(analysis.lines().RangeOf(found.span))}};
}

}  // namespace plsc::lsp
