#include "runtime/yaml_quantity.h"

#include <fmt/format.h>

#include <cassert>
#include <charconv>
#include <cmath>
#include <numbers>
#include <vector>

namespace plsc {

namespace {

// SI value = number * times / over. Two factors, because a division is exact
// to the last bit where a product with a rounded 0.01 is not.
struct Unit {
  std::string_view name;
  double times = 1;
  double over = 1;
};

struct DimensionInfo {
  std::string_view name;     // in messages, with its article
  std::string_view example;  // in SI
  std::vector<Unit> units;   // SI first, but degrees before radians
};

const DimensionInfo& InfoOf(Dimension dimension) {
  static const std::vector<DimensionInfo> infos = {
      {"a number", "0.5", {}},
      {"a time", "50 s", {{"s"}, {"ms", 1, 1000}, {"min", 60}}},
      {"a length", "0.03 m", {{"m"}, {"cm", 1, 100}, {"mm", 1, 1000}}},
      {"an angle", "5 deg", {{"deg", std::numbers::pi, 180}, {"rad"}}},
      {"an angular speed",
       "1 rad/s",
       {{"rad/s"}, {"deg/s", std::numbers::pi, 180}}},
      {"a frequency", "8 Hz", {{"Hz"}}},
      {"a rate", "0.9 1/s", {{"1/s"}}},
      {"an acceleration", "9.8 m/s2", {{"m/s2"}}},
      {"a torque", "0.18 N m", {{"N m"}}},
      {"a stiffness", "90000 N/m", {{"N/m"}}},
      {"a damping coefficient", "90000 N s/m", {{"N s/m"}}},
      {"a slip", "0.01 m/s/N", {{"m/s/N"}}},
      {"a speed", "0.5 m/s", {{"m/s"}}},
  };
  return infos[static_cast<std::size_t>(dimension)];
}

std::string_view Trim(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

ParsedQuantity NotANumber(std::string_view text, const DimensionInfo& info) {
  return {0,
          QuantityError{QuantityError::Kind::kNotANumber,
                        fmt::format("expected {}, found '{}'", info.name, text),
                        fmt::format("write it as in '{}'", info.example)}};
}

ParsedQuantity BadUnit(std::string_view number, std::string_view unit,
                       Dimension dimension) {
  const DimensionInfo& info = InfoOf(dimension);
  QuantityError error;
  error.kind = QuantityError::Kind::kUnit;
  if (info.units.empty()) {
    error.message =
        fmt::format("expected a number without a unit, found '{}'", unit);
    error.help = fmt::format("write '{}'", number);
  } else if (unit.empty()) {
    error.message = fmt::format("expected {} with its unit: {}", info.name,
                                AcceptedUnits(dimension));
    error.help = fmt::format("write '{} {}'", number, info.units.front().name);
  } else {
    error.message = fmt::format("expected {} in {}, found '{}'", info.name,
                                AcceptedUnits(dimension), unit);
    error.help = fmt::format("write it as in '{}'", info.example);
  }
  return {0, error};
}

std::optional<QuantityError> CheckRange(double value,
                                        const Quantity& quantity) {
  const bool is_low =
      quantity.is_low_excluded ? value <= quantity.low : value < quantity.low;
  if (!is_low && value <= quantity.high) return std::nullopt;
  const auto text = [&](double limit) {
    return PrintQuantity(limit, quantity.dimension);
  };
  const double most = std::numeric_limits<double>::max();
  const std::string low =
      fmt::format("{} {}", quantity.is_low_excluded ? "more than" : "at least",
                  text(quantity.low));
  const std::string high = fmt::format("at most {}", text(quantity.high));
  const std::string expected = quantity.low <= -most   ? high
                               : quantity.high >= most ? low
                                                       : low + " and " + high;
  return QuantityError{
      QuantityError::Kind::kRange,
      fmt::format("expected {}, found {}", expected, text(value)), ""};
}

}  // namespace

ParsedQuantity ParseQuantity(std::string_view text, const Quantity& quantity) {
  const DimensionInfo& info = InfoOf(quantity.dimension);
  text = Trim(text);
  // from_chars also reads "inf" and "nan", which are not quantities here.
  const std::size_t digit = text.starts_with('-') ? 1 : 0;
  const bool has_digit =
      digit < text.size() &&
      ((text[digit] >= '0' && text[digit] <= '9') || text[digit] == '.');
  double number = 0;
  const auto [end, failure] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  if (!has_digit || failure == std::errc::invalid_argument)
    return NotANumber(text, info);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (failure == std::errc::result_out_of_range)
    return {0, QuantityError{QuantityError::Kind::kRange,
                             fmt::format("{} does not fit a 64-bit "
                                         "floating-point number",
                                         text.substr(0, length)),
                             ""}};
  const std::string_view written = text.substr(0, length);
  const std::string_view unit = Trim(text.substr(length));
  ParsedQuantity parsed;
  if (unit.empty()) {
    if (quantity.dimension == Dimension::kAngle)
      return BadUnit(written, unit, quantity.dimension);
    parsed.value = number;
  } else {
    const Unit* found = nullptr;
    for (const Unit& known : info.units)
      if (known.name == unit) found = &known;
    if (found == nullptr) return BadUnit(written, unit, quantity.dimension);
    parsed.value = number * found->times / found->over;
  }
  parsed.error = CheckRange(parsed.value, quantity);
  return parsed;
}

std::string PrintQuantity(double value, Dimension dimension) {
  const DimensionInfo& info = InfoOf(dimension);
  if (dimension == Dimension::kNumber) return fmt::format("{}", value);
  if (dimension != Dimension::kAngle)
    return fmt::format("{} {}", value, info.units.front().name);
  // 12 digits hide that 5 degrees are not a round number of radians.
  std::string degrees =
      fmt::format("{:.12g} deg", value * 180 / std::numbers::pi);
  const ParsedQuantity back = ParseQuantity(degrees, {dimension});
  if (!back.error && back.value == value) return degrees;
  return fmt::format("{} rad", value);
}

std::string_view DimensionName(Dimension dimension) {
  return InfoOf(dimension).name;
}

std::string AcceptedUnits(Dimension dimension) {
  const std::vector<Unit>& units = InfoOf(dimension).units;
  std::string text;
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (i > 0) text += i + 1 == units.size() ? " or " : ", ";
    text += units[i].name;
  }
  return text;
}

}  // namespace plsc
