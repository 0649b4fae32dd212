#include "grammar/codes.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace plsc {

namespace {

constexpr CodeInfo kCodes[] = {
    {Code::kUnknownItem, "P1101",
     "something that is no item stands where an item should start"},
    {Code::kMissingName, "P1102", "a name is missing, or is a reserved word"},
    {Code::kMissingComparison, "P1103",
     "a state of a clause is not compared with anything"},
    {Code::kForeignNotation, "P1104",
     "an operator, value or mark of another language"},
    {Code::kMissingTerm, "P1105",
     "a term is missing after 'if', 'and' or 'or'"},
    {Code::kMissingThen, "P1106", "a clause does not end in 'then'"},
    {Code::kUnclosedBrace, "P1107", "a '{' is never closed"},
    {Code::kMissingValue, "P1108", "a number or another value is missing"},
    {Code::kBrokenList, "P1109", "a list in parentheses does not go on or end"},
    {Code::kMalformedNumber, "P1110", "a malformed number"},
    {Code::kForeignNumber, "P1111",
     "a number that plsc does not have: nan, inf, hexadecimal"},
    {Code::kBeyondDouble, "P1112", "a number that no double can hold"},
    {Code::kEmptyProduction, "P1113", "an empty production"},
    {Code::kParentheses, "P1114", "parentheses in a clause"},
    {Code::kMissingMark, "P1115",
     "a mark such as '->', '{', ':', '=' or '..' is missing"},
    {Code::kStrayInBraces, "P1116",
     "something that does not belong between these braces"},
    {Code::kMissingType, "P1117", "a type is missing or unknown"},
    {Code::kIncompleteAlphabet, "P1118",
     "an alphabet without a version or body"},
    {Code::kLookalike, "P1119",
     "a character that looks like another, or is invisible"},
    {Code::kUnknownSymbol, "P2001", "a symbol that the alphabet does not have"},
    {Code::kArgumentCount, "P2002", "a wrong number of arguments"},
    {Code::kNotWhole, "P2003", "an argument that must be a whole number"},
    {Code::kArgumentRange, "P2004", "an argument out of its range"},
    {Code::kUnknownState, "P2005", "a state that is not declared"},
    {Code::kValueType, "P2006",
     "a value or comparison that does not fit the state's type"},
    {Code::kNotReplaceable, "P2007",
     "a rule for a symbol that is not replaceable"},
    {Code::kMisplacedCore, "P2008",
     "the core C missing, repeated or in the wrong place"},
    {Code::kUnknownConstant, "P2009", "a constant that is not declared"},
    {Code::kUnknownAlphabet, "P2010",
     "an alphabet that does not exist, or redefines a built-in one"},
    {Code::kWrongAxiom, "P2011", "an axiom that cannot be one"},
    {Code::kMissingItem, "P2012", "a required item is missing"},
    {Code::kRepeatedItem, "P2013",
     "an item that may stand only once stands twice"},
    {Code::kWrongSetting, "P2014",
     "a setting's value of the wrong type or out of range"},
    {Code::kWrongEnvironment, "P2015",
     "an environment with a value missing, repeated or out of range"},
    {Code::kWrongState, "P2016",
     "a state with an empty range, too few values or one of them twice"},
    {Code::kRepeatedName, "P2017", "a name declared twice"},
    {Code::kWrongParameters, "P2018",
     "a symbol's parameters are too many or have wrong ranges"},
    {Code::kSeveralGenotypes, "P2019",
     "one genotype of a file with several has to be chosen"},
    {Code::kWrongTest, "P2020",
     "an inline test without what it needs, or one that asks for "
     "what is not there"},
    {Code::kImpossibleBody, "P2021", "an expected body that no robot can have"},
    {Code::kOwnLimit, "P3001",
     "more terms or rules than the genotype's own limits allow"},
    {Code::kLimit, "P3002",
     "more rules, states, symbols, values, constants or limbs than plsc "
     "can hold"},
    {Code::kTooLongString, "P4001",
     "a string that grows beyond what development may produce"},
    {Code::kFailedTest, "P4002",
     "an inline test whose expectation does not come out"},
    {Code::kTooManyEnvironments, "P4003",
     "clauses that tell apart too many environments to prove anything of all"},
    {Code::kMissingVersion, "P5001", "the version line is missing or wrong"},
    {Code::kNewerVersion, "P5002", "a file of a newer language"},
    {Code::kUnknownAlphabetVersion, "P5003",
     "a version of an alphabet that this tool does not know"},
    {Code::kMergeConflict, "P5010", "an unresolved merge conflict"},
    {Code::kNotUtf8, "P5011", "a file that is not UTF-8"},
    {Code::kAuthorsGenotype, "P5012",
     "a genotype in the notation of the authors' program"},
    {Code::kEmptyFile, "P5013", "an empty file"},
    {Code::kUnreadableFile, "P5014", "a file that cannot be read"},
    {Code::kTooLargeFile, "P5015", "a file that is too large"},
    {Code::kNotText, "P5016", "a file that is not a text"},
    {Code::kNotYamlOrJson, "P5100",
     "a scenario, experiment or study that is not YAML, or a golden file or "
     "recording that is not JSON"},
    {Code::kUnknownKey, "P5101",
     "a key of YAML or JSON that does not exist here"},
    {Code::kRepeatedKey, "P5102", "a key of YAML or JSON that is given twice"},
    {Code::kWrongKind, "P5103", "a value of YAML or JSON of the wrong kind"},
    {Code::kOutOfRange, "P5104", "a number of YAML or JSON out of its range"},
    {Code::kWrongUnit, "P5105",
     "a quantity of YAML with a missing or wrong unit"},
    {Code::kMissingKey, "P5106", "a key of YAML or JSON that is required"},
    {Code::kUnknownWord, "P5107",
     "a word of YAML or JSON that is none of those expected, or no name"},
    {Code::kMisfit, "P5108", "values of YAML or JSON that do not fit together"},
    {Code::kFormulaSyntax, "P5110", "a formula that is not written as one"},
    {Code::kUnknownQuantity, "P5111",
     "a name in a formula that is no quantity and no function"},
    {Code::kFormulaType, "P5112",
     "a part of a formula of the wrong type, or too many or few of them"},
    {Code::kNoNumber, "P5113",
     "a part of a formula that can be no number, as a division by 0"},
    {Code::kNotAuthors, "P5200",
     "a genotype of the authors' program that cannot be read, or cannot be "
     "written as one"},
    {Code::kWrongAllow, "W1001",
     "a '# plsc:' comment that asks for what does not exist"},
    {Code::kUnsensedState, "W2005",
     "a state that is given, but that the genotype does not sense"},
    {Code::kConstantClause, "W3002",
     "a clause that is true, or false, in every environment"},
    {Code::kNoActiveRule, "W3003",
     "a symbol without an active rule in some environment (on "
     "request)"},
    {Code::kSeveralActiveRules, "W3004",
     "several rules of one symbol with clauses are active at once (on "
     "request)"},
    {Code::kUnchecked, "W3005",
     "too many environments, or too long strings in them, to be checked"},
    {Code::kMayGrowTooLong, "W4001",
     "a string that in some environment grows too long (on request)"},
    {Code::kNotExpressed, "W4002",
     "a symbol that is expressed in no environment, or a rule that is used "
     "in none (on request)"},
    {Code::kOtherJoint, "W4003",
     "a command that somewhere changes another joint than the one before it "
     "(on request)"},
    {Code::kReadAgain, "W4004",
     "a rule of C that is read several times in one place (on request)"},
    {Code::kLost, "W5200",
     "something that an import or export loses, or that was lost before"},
    {Code::kParserDefect, "P1199", "a defect of the parser"},
    {Code::kFormatterDefect, "P5090", "a defect of the formatter"},
};

// No user can do anything about these: they are the last.
constexpr std::size_t kDefects = 2;

// A code is its row's index.
constexpr bool IsInOrder() {
  for (std::size_t i = 0; i < std::size(kCodes); ++i)
    if (kCodes[i].code != static_cast<Code>(i)) return false;
  return true;
}
static_assert(IsInOrder());
static_assert(kCodes[std::size(kCodes) - 1].code == Code::kFormatterDefect);

const CodeInfo& InfoOf(Code code) {
  return kCodes[static_cast<std::size_t>(code)];
}

}  // namespace

std::span<const CodeInfo> DiagnosticCodes() {
  return std::span(kCodes).first(std::size(kCodes) - kDefects);
}

std::string_view NumberOf(Code code) {
  return InfoOf(code).number;
}

std::string_view MeaningOf(Code code) {
  return InfoOf(code).meaning;
}

std::optional<Code> FindCode(std::string_view number) {
  const auto codes = DiagnosticCodes();
  const auto found =
      std::find_if(codes.begin(), codes.end(),
                   [&](const CodeInfo& info) { return info.number == number; });
  if (found == codes.end()) return std::nullopt;
  return found->code;
}

}  // namespace plsc
