#include "runtime/lsp/keyword_docs.h"

#include <algorithm>
#include <array>

namespace plsc::lsp {

namespace {

struct Doc {
  std::string_view word;
  std::string_view text;
};

// Ranges and defaults are those of compiler/limits.h and genotype.h.
constexpr std::array<Doc, 28> kDocs = {{
    {"False", "A value of a `bool` state or of `move_to_new`."},
    {"True", "A value of a `bool` state or of `move_to_new`."},
    {"alphabet",
     "`alphabet plasticoding 1`, the built-in symbols, or `alphabet NAME { "
     "... }`, the file's own."},
    {"and", "Both terms hold; binds tighter than `or`."},
    {"axiom",
     "`axiom NAME`: the symbol that development starts from; `C` with "
     "plasticoding."},
    {"bool", "A state that is `True` or `False`."},
    {"environment",
     "`environment NAME { STATE = VALUE, ... }`: what a robot senses "
     "somewhere; every state needs a value."},
    {"genotype",
     "`genotype NAME`: its name. In a file of several, each begins with it."},
    {"if", "`if CLAUSE then`: the rule is active while the clause holds."},
    {"in", "Before the range of a `real`, or the environment of a test."},
    {"include", "Reserved; has no meaning yet."},
    {"int", "A parameter that is a whole number."},
    {"iterations",
     "`iterations N`: rewritings of the string; 0 to 100, 3 "
     "when left out."},
    {"let", "`let NAME = NUMBER`: a constant."},
    {"max_modules",
     "`max_modules N`: modules of a body, the core counted, sensors not; 1 to "
     "1000, 15 when left out."},
    {"max_rules",
     "`max_rules N`: rules that a symbol may have; 1 to 1000, no limit when "
     "left out."},
    {"max_terms",
     "`max_terms N`: terms that a clause may have; 1 to 1000, no limit when "
     "left out."},
    {"move_to_new",
     "`move_to_new True`: the module-reference follows a new module; `False` "
     "when left out."},
    {"not", "Reserved; write `hot = False` or `ground != wet`."},
    {"or", "One term holds or both; `and` binds tighter."},
    {"plsc", "`plsc 1`: the version of the language; comes first."},
    {"real", "`real in LOW..HIGH`: a number, both ends included."},
    {"replaceable", "Symbols of an alphabet that rules may rewrite."},
    {"rule",
     "`rule HEAD -> [if CLAUSE then] { SYMBOLS }`: while the clause holds, "
     "HEAD is rewritten into the symbols. All active rules of a symbol are "
     "joined; without one it stays."},
    {"sense", "`sense NAME: TYPE`: a state that clauses may ask about."},
    {"terminal", "Symbols of an alphabet that no rule rewrites."},
    {"test",
     "`test NAME [in ENVIRONMENT] [after N] -> ...`: what the genotype is "
     "expected to develop into; run by `plsc test`."},
    {"then", "Ends the clause of a rule."},
}};

}  // namespace

std::string_view KeywordDoc(std::string_view word) {
  const auto found =
      std::find_if(kDocs.begin(), kDocs.end(),
                   [&](const Doc& doc) { return doc.word == word; });
  return found == kDocs.end() ? std::string_view() : found->text;
}

}  // namespace plsc::lsp
