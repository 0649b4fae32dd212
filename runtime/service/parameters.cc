#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "runtime/service/asks.h"
#include "runtime/service/limits.h"
#include "runtime/service/numbers.h"
#include "runtime/service/refusal.h"
#include "runtime/service/subject.h"

namespace plsc::service {

namespace {

using Json = nlohmann::ordered_json;

Json BoundJson(double bound) {
  return std::isinf(bound) ? Json(nullptr) : Json(bound);
}

Json NumberJson(const TurnableNumber& number, const Source& source) {
  const Position place = source.PositionOf(number.span.begin);
  const SliderRange range = SliderOf(number);
  Json json;
  json["kind"] = number.kind;
  json["name"] = number.name;
  json["about"] = number.about;
  json["line"] = place.line;
  json["column"] = place.column;
  json["byte_begin"] = number.span.begin;
  json["byte_end"] = number.span.end;
  json["value"] = number.value;
  json["whole"] = number.is_whole;
  json["lowest"] = BoundJson(number.lowest);
  json["highest"] = BoundJson(number.highest);
  json["from"] = range.from;
  json["to"] = range.to;
  json["step"] = range.step;
  return json;
}

std::uint32_t OffsetIn(const Request& request, const Source& source) {
  constexpr int kMost = std::numeric_limits<int>::max();
  const nlohmann::json& at = request.Object("at");
  const Position place{
      static_cast<int>(Request::Whole(at, "line", 1, kMost)),
      static_cast<int>(Request::Whole(at, "column", 1, kMost))};
  const auto offset = source.OffsetOf(place);
  if (!offset)
    throw Refusal(fmt::format("the text has no line {} with a column {}",
                              place.line, place.column));
  return *offset;
}

}  // namespace

Answer Parameters(const Request& request) {
  const Source source = TextOf(request);
  lsp::Analysis analysis(source.name(), std::string(source.text()));
  std::vector<TurnableNumber> numbers = NumbersOf(analysis);
  if (request.Has("at")) {
    const auto one = NumberAt(analysis, numbers, OffsetIn(request, source));
    numbers.clear();
    if (one) numbers.push_back(*one);
  }
  if (numbers.size() > kMostNumbers)
    throw Refusal(
        fmt::format("the text has {} numbers, more than {}; ask for "
                    "the one at a place",
                    numbers.size(), kMostNumbers));
  Json all = Json::array();
  for (const TurnableNumber& number : numbers)
    all.push_back(NumberJson(number, source));
  Answer answer;
  answer.Add("parameters", all);
  return answer;
}

}  // namespace plsc::service
