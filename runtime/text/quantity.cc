// A unit is two factors, one to multiply and one to divide by: 35 cm is 35 /
// 100 m, to the last bit the double that "0.35 m" is, while 35 * 0.01 is
// another one. Files written in either way are thereby equal experiments, with
// equal keys.
//
// What is not accepted is guessed at from a table of other names and larger
// units; a guess is offered only if it would be accepted itself, range
// included.

#include "runtime/text/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "grammar/number.h"
#include "grammar/suggest.h"

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
      {"a length",
       "0.03 m",
       {{"m"}, {"cm", 1, 100}, {"mm", 1, 1000}, {"um", 1, 1e6}}},
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

// What else units are called, and units that nobody needs to know here:
// "2 h" is "120 min".
struct Alias {
  std::string_view name;
  std::string_view unit;
  double times = 1;
};

constexpr Alias kAliases[] = {
    {"sec", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"millisecond", "ms"},
    {"milliseconds", "ms"},
    {"us", "ms", 0.001},
    {"minute", "min"},
    {"minutes", "min"},
    {"h", "min", 60},
    {"hour", "min", 60},
    {"hours", "min", 60},
    {"meter", "m"},
    {"metre", "m"},
    {"meters", "m"},
    {"metres", "m"},
    {"km", "m", 1000},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"\u00B0", "deg"},
    {"radian", "rad"},
    {"radians", "rad"},
    {"\u00B0/s", "deg/s"},
    {"rad s-1", "rad/s"},
    {"kHz", "Hz", 1000},
    {"1/s", "Hz"},
    {"Hz", "1/s"},
    {"/s", "1/s"},
    {"s-1", "1/s"},
    {"s^-1", "1/s"},
    {"m/s^2", "m/s2"},
    {"m/s\u00B2", "m/s2"},
    {"m/s/s", "m/s2"},
    {"Nm", "N m"},
    {"N*m", "N m"},
    {"N\u00B7m", "N m"},
    {"kN/m", "N/m", 1000},
    {"N/mm", "N/m", 1000},
    {"Ns/m", "N s/m"},
    {"N*s/m", "N s/m"},
    {"N\u00B7s/m", "N s/m"},
    {"cm/s", "m/s", 0.01},
    {"mm/s", "m/s", 0.001},
    {"km/h", "m/s", 1 / 3.6},
};

bool IsAccepted(const std::string& text, const Quantity& quantity) {
  return !ParseQuantity(text, quantity).error;
}

// Quantities that may have been meant, the likeliest first.
std::vector<std::string> Meant(std::string_view number, std::string_view unit,
                               const Quantity& quantity) {
  std::vector<std::string> meant;
  const double value = ReadNumber<double>(number).value;
  const bool has_unit = !InfoOf(quantity.dimension).units.empty();
  const auto add = [&](std::string_view text, std::string_view known) {
    meant.push_back(known.empty() ? std::string(text)
                                  : fmt::format("{} {}", text, known));
  };
  // A comma for the point; of "1,000" nobody knows.
  const std::size_t digits =
      std::min(unit.find_first_not_of("0123456789", 1), unit.size());
  if (unit.starts_with(',') && digits != 1 && digits != 4) {
    add(fmt::format("{}.{}", number, unit.substr(1)), "");
    return meant;
  }
  if (!has_unit) {
    if (unit == "%" || unit == "percent" || unit == "per cent")
      add(PrintPlainNumber(value / 100), "");
    else
      add(number, "");
    return meant;
  }
  std::vector<std::string_view> names;
  for (const Unit& known : InfoOf(quantity.dimension).units)
    names.push_back(known.name);
  if (unit.empty()) {
    for (const std::string_view name : names) add(number, name);
    return meant;
  }
  for (const Alias& alias : kAliases)
    if (alias.name == unit &&
        std::find(names.begin(), names.end(), alias.unit) != names.end())
      add(alias.times == 1 ? std::string(number)
                           : PrintPlainNumber(value * alias.times),
          alias.unit);
  // "m/s" is no slip of the pen for "ms".
  if (const auto near = Suggest(unit, names);
      near && std::count(unit.begin(), unit.end(), '/') ==
                  std::count(near->begin(), near->end(), '/'))
    add(number, *near);
  return meant;
}

// Fills in what to write instead.
QuantityError WithHelp(QuantityError error,
                       const std::vector<std::string>& meant,
                       const Quantity& quantity) {
  for (const std::string& text : meant) {
    if (!IsAccepted(text, quantity)) continue;
    error.help = fmt::format("write '{}'", text);
    error.replacement = text;
    return error;
  }
  error.help = fmt::format("write it as in '{}'", ExampleOf(quantity));
  return error;
}

ParsedQuantity NotANumber(std::string_view text, const Quantity& quantity) {
  QuantityError error;
  error.kind = QuantityError::Kind::kNotANumber;
  error.message = fmt::format("expected {}, found '{}'",
                              InfoOf(quantity.dimension).name, text);
  return {0, WithHelp(std::move(error), {}, quantity)};
}

ParsedQuantity BadUnit(std::string_view number, std::string_view unit,
                       const Quantity& quantity) {
  const DimensionInfo& info = InfoOf(quantity.dimension);
  QuantityError error;
  error.kind = QuantityError::Kind::kUnit;
  if (info.units.empty())
    error.message =
        fmt::format("expected a number without a unit, found '{}'", unit);
  else if (unit.empty())
    error.message = fmt::format("expected {} with its unit: {}", info.name,
                                AcceptedUnits(quantity.dimension));
  else
    error.message = fmt::format("expected {} in {}, found '{}'", info.name,
                                AcceptedUnits(quantity.dimension), unit);
  return {0,
          WithHelp(std::move(error), Meant(number, unit, quantity), quantity)};
}

// "80" of a share is 80 %.
std::string RangeHelp(double value, const Quantity& quantity) {
  const bool is_share = quantity.dimension == Dimension::kNumber &&
                        quantity.low == 0 && quantity.high == 1;
  if (!is_share || value <= 1 || value > 100) return "";
  return fmt::format("write '{}' for {} %", PrintPlainNumber(value / 100),
                     PrintPlainNumber(value));
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
      fmt::format("expected {}, found {}", expected, text(value)),
      RangeHelp(value, quantity)};
}

}  // namespace

ParsedQuantity ParseQuantity(std::string_view text, const Quantity& quantity) {
  const DimensionInfo& info = InfoOf(quantity.dimension);
  text = Trim(text);
  // "inf" and "nan" are numbers, but no quantities.
  const std::size_t digit = text.starts_with('-') ? 1 : 0;
  const bool has_digit =
      digit < text.size() &&
      ((text[digit] >= '0' && text[digit] <= '9') || text[digit] == '.');
  using Kind = LeadingNumber<double>::Kind;
  const auto [kind, number, length] = ReadNumber<double>(text);
  if (!has_digit || kind == Kind::kNone) return NotANumber(text, quantity);
  if (kind == Kind::kOutOfRange)
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
      return BadUnit(written, unit, quantity);
    parsed.value = number;
  } else {
    const Unit* found = nullptr;
    for (const Unit& known : info.units)
      if (known.name == unit) found = &known;
    if (found == nullptr) return BadUnit(written, unit, quantity);
    parsed.value = number * found->times / found->over;
  }
  parsed.error = CheckRange(parsed.value, quantity);
  return parsed;
}

std::string ExampleOf(const Quantity& quantity) {
  if (quantity.usual) {
    std::string text = PrintQuantity(*quantity.usual, quantity.dimension);
    if (IsAccepted(text, quantity)) return text;
  }
  std::string usual(InfoOf(quantity.dimension).example);
  if (IsAccepted(usual, quantity)) return usual;
  const bool has_high = quantity.high < std::numeric_limits<double>::max();
  return PrintQuantity(has_high ? quantity.high : quantity.low,
                       quantity.dimension);
}

std::string PrintQuantity(double value, Dimension dimension) {
  const DimensionInfo& info = InfoOf(dimension);
  if (dimension == Dimension::kNumber) return PrintPlainNumber(value);
  if (dimension != Dimension::kAngle)
    return fmt::format("{} {}", PrintPlainNumber(value),
                       info.units.front().name);
  // 12 digits hide that 5 degrees are not a round number of radians.
  std::string degrees =
      PrintRoundedNumber(value * 180 / std::numbers::pi, 12) + " deg";
  const ParsedQuantity back = ParseQuantity(degrees, {dimension});
  if (!back.error && back.value == value) return degrees;
  return PrintPlainNumber(value) + " rad";
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
