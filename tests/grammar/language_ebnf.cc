#include "grammar/language_ebnf.h"

#include "grammar/ebnf_of.h"
#include "grammar/recover.h"

namespace plsc::testing {

std::string LanguageEbnf() {
  EbnfGrammar grammar;
  // The only words about single rules. All others are called as in the
  // grammar, without the ending that tells an item from its keyword.
  grammar.names = {{"name", "name"},
                   {"argument_value", "argument"},
                   {"fraction_digits", "digits"},
                   {"term_value", "value"}};
  EbnfWalk walk(grammar);
  grammar.lexical = {walk.Add<tao::pegtl::identifier>("name"),
                     walk.Add<grammar::number>("number"),
                     walk.Add<tao::pegtl::digit>("digit")};
  grammar.start = walk.Add<grammar::file>("file");
  for (auto& [key, rule] : grammar.rules)
    for (const std::string& name : rule.names)
      if (name.ends_with("_item"))
        grammar.names[name] = name.substr(0, name.size() - 5);
  return PrintEbnf(grammar);
}

std::string WithEbnf(const std::string& document, const std::string& ebnf) {
  const std::size_t mark = document.find("<!-- grammar:");
  const std::size_t end = document.find("<!-- end of grammar -->");
  if (mark == std::string::npos || end == std::string::npos || end < mark)
    return "";
  return document.substr(0, document.find('\n', mark) + 1) + "```ebnf\n" +
         ebnf + "```\n" + document.substr(end);
}

}  // namespace plsc::testing
