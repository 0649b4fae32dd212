#include "grammar/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>
#include <type_traits>

#ifndef __cpp_lib_to_chars
#include <fast_float/fast_float.h>
#endif

namespace plsc {

namespace {

#ifdef __cpp_lib_to_chars

std::from_chars_result ReadDouble(const char* begin, const char* end,
                                  double& value) {
  return std::from_chars(begin, end, value);
}

std::to_chars_result WriteDouble(char* begin, char* end, double value) {
  return std::to_chars(begin, end, value);
}

#else  // the standard library has charconv for integers alone (libc++ 13)

/// As std::from_chars, which leaves `value` where a number fits no double;
/// fast_float makes it zero or infinite without a word.
std::from_chars_result ReadDouble(const char* begin, const char* end,
                                  double& value) {
  double read = 0;
  const auto [after, error] = fast_float::from_chars(begin, end, read);
  if (error != std::errc()) return {after, error};
  // "inf" has no digit, and zero none but 0 before its exponent.
  std::string_view mantissa(begin, static_cast<std::size_t>(after - begin));
  mantissa = mantissa.substr(0, mantissa.find_first_of("eE"));
  const char* const digits = read == 0 ? "123456789" : "0123456789";
  if ((read == 0 || std::isinf(read)) &&
      mantissa.find_first_of(digits) != std::string_view::npos)
    return {after, std::errc::result_out_of_range};
  value = read;
  return {after, error};
}

/// The digits are fmt's, the shortest that read back; as std::to_chars, with an
/// exponent only where that is shorter.
std::to_chars_result WriteDouble(char* begin, char* end, double value) {
  std::string plain = fmt::format("{}", value);
  const auto written = [&](std::string_view text) -> std::to_chars_result {
    assert(text.size() <= static_cast<std::size_t>(end - begin));
    return {std::copy(text.begin(), text.end(), begin), std::errc()};
  };
  if (!std::isfinite(value) || value == 0) return written(plain);

  // value = 0.DIGITS * 10^point
  const std::string_view sign = value < 0 ? "-" : "";
  const std::size_t e = std::min(plain.find('e'), plain.size());
  int point = 0;
  if (e < plain.size()) {
    const char* from = plain.data() + e + 1;
    if (*from == '+') ++from;
    std::from_chars(from, plain.data() + plain.size(), point);
  }
  std::string digits = plain.substr(sign.size(), e - sign.size());
  const std::size_t dot = std::min(digits.find('.'), digits.size());
  point += static_cast<int>(dot);
  if (dot < digits.size()) digits.erase(dot, 1);
  const std::size_t first = digits.find_first_not_of('0');
  point -= static_cast<int>(first);
  digits = digits.substr(first, digits.find_last_not_of('0') + 1 - first);

  const int count = static_cast<int>(digits.size());
  std::string fixed;
  if (point <= 0)
    fixed = "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  else if (point < count)
    fixed = std::string(digits).insert(static_cast<std::size_t>(point), ".");
  else  // of texts of one length the nearest, which has all digits
    fixed = fmt::format("{:.0f}", std::abs(value));
  std::string scientific = digits;
  if (count > 1) scientific.insert(1, ".");
  scientific +=
      fmt::format("e{}{:02}", point > 0 ? '+' : '-', std::abs(point - 1));
  return written(fmt::format(
      "{}{}", sign, fixed.size() <= scientific.size() ? fixed : scientific));
}

#endif

template <typename T>
LeadingNumber<T> ReadLeading(std::string_view text, auto... base) {
  using Kind = typename LeadingNumber<T>::Kind;
  LeadingNumber<T> number;
  const char* const begin = text.data();
  const char* const end_of_text = begin + text.size();
  const auto [end, error] = [&] {
    if constexpr (std::is_same_v<T, double>)
      return ReadDouble(begin, end_of_text, number.value);
    else
      return std::from_chars(begin, end_of_text, number.value, base...);
  }();
  number.length = static_cast<std::size_t>(end - begin);
  number.kind = error == std::errc()                      ? Kind::kFits
                : error == std::errc::result_out_of_range ? Kind::kOutOfRange
                                                          : Kind::kNone;
  return number;
}

/// If it is all of a text.
template <typename T>
std::optional<T> Whole(const LeadingNumber<T>& number, std::string_view text) {
  if (number.kind != LeadingNumber<T>::Kind::kFits ||
      number.length != text.size())
    return std::nullopt;
  return number.value;
}

}  // namespace

template <typename T>
LeadingNumber<T> ReadNumber(std::string_view text) {
  return ReadLeading<T>(text);
}

template <typename T>
std::optional<T> ParseNumber(std::string_view text) {
  const std::optional<T> number = Whole(ReadNumber<T>(text), text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

// The integers by their names in the language: which of them std::int64_t and
// std::size_t are is the platform's choice.
template LeadingNumber<double> ReadNumber(std::string_view);
template LeadingNumber<int> ReadNumber(std::string_view);
template LeadingNumber<unsigned> ReadNumber(std::string_view);
template LeadingNumber<long> ReadNumber(std::string_view);
template LeadingNumber<unsigned long> ReadNumber(std::string_view);
template LeadingNumber<long long> ReadNumber(std::string_view);
template LeadingNumber<unsigned long long> ReadNumber(std::string_view);
template std::optional<double> ParseNumber(std::string_view);
template std::optional<int> ParseNumber(std::string_view);
template std::optional<unsigned> ParseNumber(std::string_view);
template std::optional<long> ParseNumber(std::string_view);
template std::optional<unsigned long> ParseNumber(std::string_view);
template std::optional<long long> ParseNumber(std::string_view);
template std::optional<unsigned long long> ParseNumber(std::string_view);

std::optional<std::uint64_t> ParseHex(std::string_view digits) {
  constexpr int kBase = 16;
  return Whole(ReadLeading<std::uint64_t>(digits, kBase), digits);
}

void AppendNumber(double value, std::string* text) {
  // Shortest forms have at most 24 characters ("-2.2250738585072014e-308").
  std::array<char, 32> buffer;
  const auto [end, error] =
      WriteDouble(buffer.data(), buffer.data() + buffer.size(), value);
  assert(error == std::errc());
  text->append(buffer.data(), end);
}

std::string PrintNumber(double value) {
  std::string text;
  AppendNumber(value, &text);
  return text;
}

std::string PrintPlainNumber(double value) {
  return fmt::format("{}", value);
}

std::string PrintRoundedNumber(double value, int digits) {
  return fmt::format("{:.{}g}", value, digits);
}

}  // namespace plsc
