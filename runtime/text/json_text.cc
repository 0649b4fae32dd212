#include "runtime/text/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "grammar/screen.h"
#include "runtime/text/json_place.h"

namespace plsc {

namespace {

using Json = nlohmann::json;

// `byte` counts from 1; 0 where the library does not know.
Diagnostic NotJson(const Json::exception& error, std::size_t byte,
                   std::size_t size) {
  const auto at =
      static_cast<std::uint32_t>(std::min(byte == 0 ? 0 : byte - 1, size));
  // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax
  // error while ...": the place is shown by the caret.
  std::string_view what = error.what();
  for (const std::string_view mark : {"] ", "column "})
    if (const std::size_t i = what.find(mark); i != std::string_view::npos)
      what.remove_prefix(i + mark.size());
  const std::size_t number = what.find_first_not_of("0123456789");
  if (number > 0 && what.substr(number).starts_with(": "))
    what.remove_prefix(number + 2);
  return {Code::kNotYamlOrJson, {at, at}, fmt::format("not JSON: {}", what)};
}

}  // namespace

Result<Json> ReadJson(const Source& source) {
  if (auto problem = Screen(source)) return *problem;
  if (const auto deep = TooDeepInJson(source.text()))
    return Diagnostic(Code::kNotYamlOrJson, *deep,
                      fmt::format("expected at most {} brackets around a value",
                                  kMaxJsonDepth));
  Json json;
  try {
    json = Json::parse(source.text());
  } catch (const Json::parse_error& error) {
    return NotJson(error, error.byte, source.text().size());
  } catch (const Json::exception& error) {  // a number beyond all doubles
    return NotJson(error, 0, source.text().size());
  }
  if (const auto repeated = RepeatedJsonKey(source.text()))
    return Diagnostic(Code::kRepeatedKey, *repeated,
                      "this key stands twice in its object");
  return json;
}

}  // namespace plsc
