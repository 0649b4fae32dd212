#pragma once

// Every diagnostic code: its name in the sources, its number as users see it
// and one line about it, which the reference (docs/language.md) lists too.
// `plsc explain` has more to say of each
// (runtime/cli/explanations/explanations.h). P1 syntax, P2 names and types, P3
// regulation, P4 development, P5 files, P51 scenarios and experiments; W
// warnings. A number stands nowhere else in the sources, so that each place
// says what it reports.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace plsc {

enum class Code : std::uint8_t {
  kUnknownItem,             ///< P1101
  kMissingName,             ///< P1102
  kMissingComparison,       ///< P1103
  kForeignNotation,         ///< P1104
  kMissingTerm,             ///< P1105
  kMissingThen,             ///< P1106
  kUnclosedBrace,           ///< P1107
  kMissingValue,            ///< P1108
  kBrokenList,              ///< P1109
  kMalformedNumber,         ///< P1110
  kForeignNumber,           ///< P1111
  kBeyondDouble,            ///< P1112
  kEmptyProduction,         ///< P1113
  kParentheses,             ///< P1114
  kMissingMark,             ///< P1115
  kStrayInBraces,           ///< P1116
  kMissingType,             ///< P1117
  kIncompleteAlphabet,      ///< P1118
  kLookalike,               ///< P1119
  kUnknownSymbol,           ///< P2001
  kArgumentCount,           ///< P2002
  kNotWhole,                ///< P2003
  kArgumentRange,           ///< P2004
  kUnknownState,            ///< P2005
  kValueType,               ///< P2006
  kNotReplaceable,          ///< P2007
  kMisplacedCore,           ///< P2008
  kUnknownConstant,         ///< P2009
  kUnknownAlphabet,         ///< P2010
  kWrongAxiom,              ///< P2011
  kMissingItem,             ///< P2012
  kRepeatedItem,            ///< P2013
  kWrongSetting,            ///< P2014
  kWrongEnvironment,        ///< P2015
  kWrongState,              ///< P2016
  kRepeatedName,            ///< P2017
  kWrongParameters,         ///< P2018
  kSeveralGenotypes,        ///< P2019
  kWrongTest,               ///< P2020
  kImpossibleBody,          ///< P2021
  kOwnLimit,                ///< P3001
  kLimit,                   ///< P3002
  kTooLongString,           ///< P4001
  kFailedTest,              ///< P4002
  kTooManyEnvironments,     ///< P4003
  kMissingVersion,          ///< P5001
  kNewerVersion,            ///< P5002
  kUnknownAlphabetVersion,  ///< P5003
  kMergeConflict,           ///< P5010
  kNotUtf8,                 ///< P5011
  kAuthorsGenotype,         ///< P5012
  kEmptyFile,               ///< P5013
  kUnreadableFile,          ///< P5014
  kTooLargeFile,            ///< P5015
  kNotText,                 ///< P5016
  kNotYamlOrJson,           ///< P5100
  kUnknownKey,              ///< P5101
  kRepeatedKey,             ///< P5102
  kWrongKind,               ///< P5103
  kOutOfRange,              ///< P5104
  kWrongUnit,               ///< P5105
  kMissingKey,              ///< P5106
  kUnknownWord,             ///< P5107
  kMisfit,                  ///< P5108
  kFormulaSyntax,           ///< P5110
  kUnknownQuantity,         ///< P5111
  kFormulaType,             ///< P5112
  kNoNumber,                ///< P5113
  kNotAuthors,              ///< P5200
  kWrongAllow,              ///< W1001
  kUnsensedState,           ///< W2005
  kConstantClause,          ///< W3002
  kNoActiveRule,            ///< W3003
  kSeveralActiveRules,      ///< W3004
  kUnchecked,               ///< W3005
  kMayGrowTooLong,          ///< W4001
  kNotExpressed,            ///< W4002
  kOtherJoint,              ///< W4003
  kReadAgain,               ///< W4004
  kLost,                    ///< W5200
  kParserDefect,            ///< P1199
  kFormatterDefect,         ///< P5090
};

struct CodeInfo {
  Code code;
  std::string_view number;
  std::string_view meaning;
};

/// Sorted: errors, then warnings. Without those that tell of defects of plsc.
std::span<const CodeInfo> DiagnosticCodes();

/// "P2001"; a warning's begins with W.
std::string_view NumberOf(Code code);

/// The line about it.
std::string_view MeaningOf(Code code);

/// Nothing when no code has the number, or a defect of plsc has it.
std::optional<Code> FindCode(std::string_view number);

}  // namespace plsc
