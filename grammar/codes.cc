#include "grammar/codes.h"

namespace plsc {

namespace {

// P1199 and P5090 are left out: they tell of defects of plsc.
constexpr CodeInfo kCodes[] = {
    {"P1101", "something that is no item stands where an item should start"},
    {"P1102", "a name is missing, or is a reserved word"},
    {"P1103", "a state of a clause is not compared with anything"},
    {"P1104", "an operator, value or mark of another language"},
    {"P1105", "a term is missing after 'if', 'and' or 'or'"},
    {"P1106", "a clause does not end in 'then'"},
    {"P1107", "a '{' is never closed"},
    {"P1108", "a number or another value is missing"},
    {"P1109", "a list in parentheses does not go on or end"},
    {"P1110", "a malformed number"},
    {"P1111", "a number that plsc does not have: nan, inf, hexadecimal"},
    {"P1112", "a number that no double can hold"},
    {"P1113", "an empty production"},
    {"P1114", "parentheses in a clause"},
    {"P1115", "a mark such as '->', '{', ':', '=' or '..' is missing"},
    {"P1116", "something that does not belong between these braces"},
    {"P1117", "a type is missing or unknown"},
    {"P1118", "an alphabet without a version or body"},
    {"P1119", "a character that looks like another, or is invisible"},
    {"P2001", "a symbol that the alphabet does not have"},
    {"P2002", "a wrong number of arguments"},
    {"P2003", "an argument that must be a whole number"},
    {"P2004", "an argument out of its range"},
    {"P2005", "a state that is not declared"},
    {"P2006", "a value or comparison that does not fit the state's type"},
    {"P2007", "a rule for a symbol that is not replaceable"},
    {"P2008", "the core C missing, repeated or in the wrong place"},
    {"P2009", "a constant that is not declared"},
    {"P2010", "an alphabet that does not exist, or redefines a built-in one"},
    {"P2011", "an axiom that cannot be one"},
    {"P2012", "a required item is missing"},
    {"P2013", "an item that may stand only once stands twice"},
    {"P2014", "a setting's value of the wrong type or out of range"},
    {"P2015", "an environment with a value missing, repeated or out of range"},
    {"P2016",
     "a state with an empty range, too few values or one of them twice"},
    {"P2017", "a name declared twice"},
    {"P2018", "a symbol's parameters are too many or have wrong ranges"},
    {"P2019", "one genotype of a file with several has to be chosen"},
    {"P2020",
     "an inline test without what it needs, or one that asks for "
     "what is not there"},
    {"P2021", "an expected body that no robot can have"},
    {"P3001", "more terms or rules than the genotype's own limits allow"},
    {"P3002",
     "more rules, states, symbols, values, constants or limbs than plsc "
     "can hold"},
    {"P4001", "a string that grows beyond what development may produce"},
    {"P4002", "an inline test whose expectation does not come out"},
    {"P4003",
     "clauses that tell apart too many environments to prove anything of all"},
    {"P5001", "the version line is missing or wrong"},
    {"P5002", "a file of a newer language"},
    {"P5003", "a version of an alphabet that this tool does not know"},
    {"P5010", "an unresolved merge conflict"},
    {"P5011", "a file that is not UTF-8"},
    {"P5012", "a genotype in the notation of the authors' program"},
    {"P5013", "an empty file"},
    {"P5014", "a file that cannot be read"},
    {"P5015", "a file that is too large"},
    {"P5016", "a file that is not a text"},
    {"P5100",
     "a scenario, experiment or study that is not YAML, or a golden file or "
     "recording that is not JSON"},
    {"P5101", "a key of YAML or JSON that does not exist here"},
    {"P5102", "a key of YAML or JSON that is given twice"},
    {"P5103", "a value of YAML or JSON of the wrong kind"},
    {"P5104", "a number of YAML or JSON out of its range"},
    {"P5105", "a quantity of YAML with a missing or wrong unit"},
    {"P5106", "a key of YAML or JSON that is required"},
    {"P5107",
     "a word of YAML or JSON that is none of those expected, or no name"},
    {"P5108", "values of YAML or JSON that do not fit together"},
    {"P5200",
     "a genotype of the authors' program that cannot be read, or cannot be "
     "written as one"},
    {"W1001", "a '# plsc:' comment that asks for what does not exist"},
    {"W2005", "a state that is given, but that the genotype does not sense"},
    {"W3002", "a clause that is true, or false, in every environment"},
    {"W3003",
     "a symbol without an active rule in some environment (on "
     "request)"},
    {"W3004",
     "several rules of one symbol with clauses are active at once (on "
     "request)"},
    {"W3005",
     "too many environments, or too long strings in them, to be checked"},
    {"W4001", "a string that in some environment grows too long (on request)"},
    {"W4002",
     "a symbol that is expressed in no environment, or a rule that is used "
     "in none (on request)"},
    {"W4003",
     "a command that somewhere changes another joint than the one before it "
     "(on request)"},
    {"W4004",
     "a rule of C that is read several times in one place (on request)"},
    {"W5200",
     "something that an import or export loses, or that was lost before"},
};

}  // namespace

std::span<const CodeInfo> DiagnosticCodes() {
  return kCodes;
}

std::string_view MeaningOf(std::string_view code) {
  for (const CodeInfo& info : kCodes)
    if (info.code == code) return info.meaning;
  return {};
}

}  // namespace plsc
