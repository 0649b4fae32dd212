#pragma once

// What the parser knows when the text is not what the grammar requires: what
// was required, and where.

#include <cstdint>
#include <string_view>

#include "grammar/diagnostic.h"

namespace plsc {

/// What the grammar required, by what is reported when it is not there.
enum class SyntaxError : std::uint8_t {
  kInternal,  ///< of rules that cannot fail; seen only if the grammar is wrong
  kVersionWord,
  kVersionNumber,
  kItem,
  kName,
  kArrow,
  kOpenBrace,
  kFirstSymbol,
  kProductionEnd,
  kTerm,
  kComparison,
  kTermValue,
  kThen,
  kArgument,
  kCloseParen,
  kDigits,
  kNumberEnd,
  kEquals,
  kNumber,
  kSettingValue,
  kColon,
  kStateType,
  kIn,
  kDots,
  kEnumValue,
  kEnumEnd,
  kAlphabetBody,
  kGroup,
  kAlphabetEnd,
  kParameterType,
  kParametersEnd,
  kEntryValue,
  kEnvironmentEnd,
  kModule,
  kBodyEnd,
  kBodyDepth,
};

/// Where the parser was when it could not go on.
struct SyntaxContext {
  std::string_view text;           ///< of the whole file
  std::uint32_t offset = 0;        ///< where the required rule did not match
  std::uint32_t previous_end = 0;  ///< end of the last token before it
  Span item;                       ///< keyword of the item around it
  Span open;                       ///< the last '{' that was opened
};

}  // namespace plsc
