// What may stand at the cursor, by the words before it since the last item's
// keyword. The grammar would not help: an item that is being typed fails at the
// cursor by definition. Words are enough because the language is LL(1): the
// last one or two words, the open braces and the item's keyword decide what is
// next. Nothing is said where the cursor touches a comment or a number.

#include "runtime/lsp/completion_context.h"

#include <algorithm>
#include <iterator>

#include "grammar/keywords.h"
#include "runtime/lsp/tokens.h"

namespace plsc::lsp {

namespace {

using Words = std::vector<std::string_view>;

bool IsComparison(std::string_view word) {
  return word == "=" || word == "!=" || word == "<" || word == "<=" ||
         word == ">" || word == ">=";
}

bool IsIdentifier(std::string_view word) {
  return IsWordCharacter(word[0]) && !(word[0] >= '0' && word[0] <= '9');
}

int OpenBraces(const Words& words) {
  return static_cast<int>(std::count(words.begin(), words.end(), "{") -
                          std::count(words.begin(), words.end(), "}"));
}

bool IsInParentheses(const Words& words) {
  const auto open = std::find(words.rbegin(), words.rend(), "(");
  return open != words.rend() && std::find(words.rbegin(), open, ")") == open;
}

// Of a production or an own alphabet's symbols.
Wanted InSymbols(const Words& words) {
  return IsInParentheses(words) ? Wanted::kConstant : Wanted::kSymbol;
}

void InClause(const Words& words, CompletionContext* context) {
  const std::string_view last = words.back();
  if (last == "if" || last == "and" || last == "or") {
    context->wanted = Wanted::kState;
  } else if (IsComparison(last)) {
    context->wanted = Wanted::kValue;
    if (words.size() >= 2) context->subject = words[words.size() - 2];
  } else if (words.size() >= 2 && IsComparison(words[words.size() - 2])) {
    context->wanted = Wanted::kConnective;
  } else if (IsIdentifier(last)) {
    context->wanted = Wanted::kComparison;
    context->subject = last;
  }
}

// words[0] is `rule`.
void InRule(const Words& words, CompletionContext* context) {
  const std::string_view last = words.back();
  if (OpenBraces(words) > 0) {
    context->wanted = InSymbols(words);
  } else if (last == "rule") {
    context->wanted = Wanted::kHead;
  } else if (last == "->") {
    context->wanted = Wanted::kClauseOrBrace;
  } else if (last == "then") {
    context->wanted = Wanted::kBrace;
  } else if (last == "}") {
    context->wanted = Wanted::kItem;
  } else if (std::find(words.begin(), words.end(), "if") != words.end()) {
    InClause(words, context);
  }
}

void InEnvironment(const Words& words, CompletionContext* context) {
  const std::string_view last = words.back();
  if (OpenBraces(words) == 0) {
    context->wanted = last == "}" ? Wanted::kItem : Wanted::kNothing;
    return;
  }
  if (last == "=") {
    context->wanted = Wanted::kValue;
    context->subject = words[words.size() - 2];
    return;
  }
  // After a state itself '=' is to come.
  const bool is_state = IsIdentifier(last) && words[words.size() - 2] != "=";
  if (is_state) return;
  context->wanted = Wanted::kEntry;
  for (std::size_t i = 1; i < words.size(); ++i)
    if (words[i] == "=") context->given.push_back(words[i - 1]);
}

void InTest(const Words& words, CompletionContext* context) {
  const std::string_view last = words.back();
  const auto arrow = std::find(words.begin(), words.end(), "->");
  if (arrow == words.end()) {
    if (last == "in")
      context->wanted = Wanted::kEnvironment;
    else if (words.size() > 1 && last != "after")
      context->wanted = Wanted::kTestWord;
    return;
  }
  const bool is_body =
      std::next(arrow) != words.end() && *std::next(arrow) == "body";
  if (last == "->") {
    context->wanted = Wanted::kExpectation;
  } else if (!is_body) {
    context->wanted = OpenBraces(words) > 0 ? InSymbols(words) : Wanted::kItem;
  } else if (last == "body" || last == "front" || last == "left" ||
             last == "right" || last == "back") {
    context->wanted = Wanted::kModule;
  } else {
    context->wanted = OpenBraces(words) > 0 ? Wanted::kFace : Wanted::kItem;
  }
}

void InHeader(const Words& words, CompletionContext* context) {
  const std::string_view first = words[0];
  const bool is_first = words.size() == 1;
  if (first == "sense") {
    if (words.back() == ":")
      context->wanted = Wanted::kType;
    else if (words.size() > 3 && OpenBraces(words) == 0 && words.back() != "in")
      context->wanted = Wanted::kItem;
  } else if (first == "axiom") {
    context->wanted = is_first ? Wanted::kAxiom : Wanted::kItem;
  } else if (first == "move_to_new") {
    context->wanted = is_first ? Wanted::kTruth : Wanted::kItem;
  } else if (first == "alphabet") {
    if (is_first)
      context->wanted = Wanted::kAlphabet;
    else if (words.size() > 2 && OpenBraces(words) == 0)
      context->wanted = Wanted::kItem;
  } else if (first == "let") {
    if (words.size() > 3) context->wanted = Wanted::kItem;
  } else if (!is_first) {
    context->wanted = Wanted::kItem;  // genotype NAME, iterations 3
  }
}

}  // namespace

CompletionContext ContextAt(std::string_view text, std::uint32_t offset) {
  CompletionContext context;
  context.word = {offset, offset};
  Words words;  // of the item
  for (const Token& token : Tokenize(text)) {
    if (token.span.begin >= offset) break;
    const bool touches = token.span.end >= offset;
    if (token.kind == TokenKind::kComment) {
      if (touches) return context;
      continue;
    }
    if (touches &&
        (token.kind == TokenKind::kNumber || token.kind == TokenKind::kOther))
      return context;
    if (touches && token.kind == TokenKind::kWord) {
      context.word = {token.span.begin, offset};
      break;
    }
    const std::string_view word =
        text.substr(token.span.begin, token.span.end - token.span.begin);
    // A genotype may be called `test`.
    if (IsItemKeyword(word) &&
        !(word == "test" && !words.empty() && words.back() == "genotype"))
      words.clear();
    words.push_back(word);
  }
  if (words.empty()) {
    context.wanted = Wanted::kItem;
  } else if (words[0] == "rule") {
    InRule(words, &context);
  } else if (words[0] == "environment") {
    InEnvironment(words, &context);
  } else if (words[0] == "test") {
    InTest(words, &context);
  } else if (words[0] == "plsc") {
    context.wanted = words.size() > 1 ? Wanted::kItem : Wanted::kNothing;
  } else {
    InHeader(words, &context);
  }
  return context;
}

}  // namespace plsc::lsp
