// Ten numbers in the order of the fields, each the shortest text that reads
// back to the same bits. A field that is added must be added here, or lives
// that differ in it would have one key; the structured binding sees to that.

#include "runtime/life/disturbances.h"

#include <fmt/format.h>

#include <cassert>

#include "grammar/number.h"

namespace plsc {

namespace {

constexpr std::string_view kWord = "disturbed";

template <typename T>
T TakeWord(std::string_view& text) {
  assert(text.starts_with(' '));
  text.remove_prefix(1);
  const LeadingNumber<T> number = ReadNumber<T>(text);
  assert(number.kind == LeadingNumber<T>::Kind::kFits);
  text.remove_prefix(number.length);
  return number.value;
}

Noise TakeNoise(std::string_view& text) {
  const auto amplitude = TakeWord<double>(text);
  return {amplitude, TakeWord<std::uint64_t>(text)};
}

std::string NoiseText(const Noise& noise) {
  return fmt::format(" {} {}", PrintNumber(noise.amplitude), noise.seed);
}

}  // namespace

Disturbance DisturbanceIn(const Disturbances& disturbances,
                          std::size_t season) {
  return disturbances.empty() ? Disturbance{} : disturbances.at(season);
}

std::string DisturbanceText(const Disturbance& disturbance) {
  if (disturbance == Disturbance{}) return "";
  const auto& [lift, x, y, yaw, friction, lean, touch, motor] = disturbance;
  std::string text(kWord);
  for (const double number : {lift, x, y, yaw, friction, lean})
    text += ' ' + PrintNumber(number);
  return text + NoiseText(touch) + NoiseText(motor) + '\n';
}

Disturbance ReadDisturbance(std::string_view text) {
  Disturbance disturbance;
  if (text.empty()) return disturbance;
  assert(text.starts_with(kWord));
  text.remove_prefix(kWord.size());
  auto& [lift, x, y, yaw, friction, lean, touch, motor] = disturbance;
  for (double* number : {&lift, &x, &y, &yaw, &friction, &lean})
    *number = TakeWord<double>(text);
  touch = TakeNoise(text);
  motor = TakeNoise(text);
  return disturbance;
}

}  // namespace plsc
