#pragma once

// Scanners for the three tokens that texts mostly are: gaps, names and
// numbers. rules.h says what matches; a scanner only recognises the plain case
// of its rule quicker and leaves all else (comments, errors, what does not
// match) to the rule. tests/grammar/fast_match_test.cc parses with and without
// them and wants the same tree. Parsing takes a quarter less time with them.

#include <array>
#include <cstdint>
#include <type_traits>

#include "grammar/keywords.h"
#include "grammar/rules.h"

namespace plsc::grammar {

enum class ByteClass : std::uint8_t { kOther, kBlank, kDigit, kLetter };

// By the unsigned value of the byte. kLetter includes '_'.
inline constexpr auto kByteClasses = [] {
  std::array<ByteClass, 256> classes{};
  for (std::size_t i = 0; i < 128; ++i) {
    const char c = static_cast<char>(i);
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
      classes[i] = ByteClass::kBlank;
    else if (c >= '0' && c <= '9')
      classes[i] = ByteClass::kDigit;
    else if (IsWordCharacter(c))
      classes[i] = ByteClass::kLetter;
  }
  return classes;
}();

inline ByteClass ClassOf(char c) {
  return kByteClasses[static_cast<unsigned char>(c)];
}

/// The end of the gap at `at`; nullptr when the rule has to look.
inline const char* ScanGap(const char* at, const char* end) {
  while (at != end && ClassOf(*at) == ByteClass::kBlank) ++at;
  return at != end && *at == '#' ? nullptr : at;
}

/// The end of the identifier at `at`, or nullptr.
inline const char* ScanIdentifier(const char* at, const char* end) {
  if (at == end || ClassOf(*at) != ByteClass::kLetter) return nullptr;
  while (++at != end && ClassOf(*at) >= ByteClass::kDigit) continue;
  return at;
}

/// Behind the digits at `at`; nullptr when there is none.
inline const char* ScanDigits(const char* at, const char* end) {
  const char* const begin = at;
  while (at != end && ClassOf(*at) == ByteClass::kDigit) ++at;
  return at == begin ? nullptr : at;
}

/// The end of the number at `at`; nullptr when there is none and when the rule
/// has to look: before '.' it may be a range or an error.
inline const char* ScanNumber(const char* at, const char* end) {
  if (at != end && *at == '-') ++at;
  at = ScanDigits(at, end);
  if (at != nullptr && at != end && *at == '.') at = ScanDigits(at + 1, end);
  if (at != nullptr && at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != end && (*at == '+' || *at == '-')) ++at;
    at = ScanDigits(at, end);
  }
  if (at == nullptr || at == end) return at;
  return *at == '.' || ClassOf(*at) >= ByteClass::kDigit ? nullptr : at;
}

/// A base for controls; Rule is `gap`, `number` or any `identifier`, and all
/// other rules match as PEGTL's normal<> does.
template <typename Rule>
struct FastMatch : normal<Rule> {
  static constexpr bool kIsGap = std::is_same_v<Rule, gap>;
  static constexpr bool kIsNumber = std::is_same_v<Rule, number>;
  static constexpr bool kIsIdentifier = std::is_base_of_v<identifier, Rule>;

  static const char* Scan(const char* at, const char* end) {
    if constexpr (kIsGap) return ScanGap(at, end);
    if constexpr (kIsNumber) return ScanNumber(at, end);
    return ScanIdentifier(at, end);
  }

  template <apply_mode kApply, rewind_mode kRewind,
            template <typename...> class Action,
            template <typename...> class Control, typename Input,
            typename State>
  static bool match(Input& in, State& state) {
    using ActionInput = typename Input::action_t;
    if constexpr ((kIsGap || kIsNumber || kIsIdentifier) &&
                  kApply == apply_mode::action &&
                  requires(const ActionInput& matched) {
                    Action<Rule>::apply(matched, state);
                  }) {
      const char* const begin = in.current();
      if (const char* const end = Scan(begin, in.end())) {
        in.bump(static_cast<std::size_t>(end - begin));
        return Apply<Action<Rule>>(begin, in, state);
      }
    }
    return tao::pegtl::match<Rule, kApply, kRewind, Action, Control>(in, state);
  }

 private:
  // An action that returns false undoes the match.
  template <typename Action, typename Input, typename State>
  static bool Apply(const char* begin, Input& in, State& state) {
    const typename Input::action_t matched(begin, in);
    if constexpr (std::is_same_v<decltype(Action::apply(matched, state)),
                                 bool>) {
      if (Action::apply(matched, state)) return true;
      in.iterator() = begin;
      return false;
    } else {
      Action::apply(matched, state);
      return true;
    }
  }
};

}  // namespace plsc::grammar
