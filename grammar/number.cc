#include "grammar/number.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <system_error>

namespace plsc {

namespace {

template <typename T>
LeadingNumber<T> ReadLeading(std::string_view text, auto... base) {
  using Kind = typename LeadingNumber<T>::Kind;
  LeadingNumber<T> number;
  const char* const begin = text.data();
  const auto [end, error] =
      std::from_chars(begin, begin + text.size(), number.value, base...);
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
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
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
