#pragma once

// Which failure of which rule is which SyntaxError. Rules that cannot fail
// (gap, star, opt) keep kInternal; the fuzzer stops if it ever sees that one.

#include "grammar/rules.h"
#include "grammar/syntax_error.h"

namespace plsc::grammar {

template <typename Rule>
inline constexpr SyntaxError kError = SyntaxError::kInternal;

// clang-format off
template <> inline constexpr auto kError<wanted_plsc>          = SyntaxError::kVersionWord;
template <> inline constexpr auto kError<wanted_version>       = SyntaxError::kVersionNumber;
template <> inline constexpr auto kError<item>                 = SyntaxError::kItem;
template <> inline constexpr auto kError<wanted_name>          = SyntaxError::kName;
template <> inline constexpr auto kError<wanted_genotype_name> = SyntaxError::kName;
template <> inline constexpr auto kError<wanted_head>          = SyntaxError::kName;
template <> inline constexpr auto kError<wanted_declared>      = SyntaxError::kName;
template <> inline constexpr auto kError<wanted_parameter>     = SyntaxError::kName;
template <> inline constexpr auto kError<arrow>                = SyntaxError::kArrow;
template <> inline constexpr auto kError<open_brace>           = SyntaxError::kOpenBrace;
template <> inline constexpr auto kError<environment_open>     = SyntaxError::kOpenBrace;
template <> inline constexpr auto kError<first_symbol>         = SyntaxError::kFirstSymbol;
template <> inline constexpr auto kError<production_end>       = SyntaxError::kProductionEnd;
template <> inline constexpr auto kError<term>                 = SyntaxError::kTerm;
template <> inline constexpr auto kError<comparison>           = SyntaxError::kComparison;
template <> inline constexpr auto kError<wanted_value>         = SyntaxError::kTermValue;
template <> inline constexpr auto kError<then_word>            = SyntaxError::kThen;
template <> inline constexpr auto kError<argument>             = SyntaxError::kArgument;
template <> inline constexpr auto kError<close_paren>          = SyntaxError::kCloseParen;
template <> inline constexpr auto kError<fraction_digits>      = SyntaxError::kDigits;
template <> inline constexpr auto kError<exponent_digits>      = SyntaxError::kDigits;
template <> inline constexpr auto kError<number_end>           = SyntaxError::kNumberEnd;
template <> inline constexpr auto kError<equals_mark>          = SyntaxError::kEquals;
template <> inline constexpr auto kError<let_number>           = SyntaxError::kNumber;
template <> inline constexpr auto kError<wanted_low>           = SyntaxError::kNumber;
template <> inline constexpr auto kError<wanted_high>          = SyntaxError::kNumber;
template <> inline constexpr auto kError<wanted_setting_value> = SyntaxError::kSettingValue;
template <> inline constexpr auto kError<colon>                = SyntaxError::kColon;
template <> inline constexpr auto kError<state_type>           = SyntaxError::kStateType;
template <> inline constexpr auto kError<in_word>              = SyntaxError::kIn;
template <> inline constexpr auto kError<dots>                 = SyntaxError::kDots;
template <> inline constexpr auto kError<wanted_enum_value>    = SyntaxError::kEnumValue;
template <> inline constexpr auto kError<enum_end>             = SyntaxError::kEnumEnd;
template <> inline constexpr auto kError<alphabet_body>        = SyntaxError::kAlphabetBody;
template <> inline constexpr auto kError<first_group>          = SyntaxError::kGroup;
template <> inline constexpr auto kError<alphabet_end>         = SyntaxError::kAlphabetEnd;
template <> inline constexpr auto kError<number_type>          = SyntaxError::kParameterType;
template <> inline constexpr auto kError<parameters_end>       = SyntaxError::kParametersEnd;
template <> inline constexpr auto kError<wanted_entry_value>   = SyntaxError::kEntryValue;
template <> inline constexpr auto kError<body_module>          = SyntaxError::kModule;
template <> inline constexpr auto kError<children_end>         = SyntaxError::kBodyEnd;
template <> inline constexpr auto kError<wanted_place>         = SyntaxError::kName;
template <> inline constexpr auto kError<after_number>         = SyntaxError::kNumber;
template <> inline constexpr auto kError<environment_end>      = SyntaxError::kEnvironmentEnd;
// clang-format on

}  // namespace plsc::grammar
