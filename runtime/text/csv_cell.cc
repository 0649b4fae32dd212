#include "runtime/text/csv_cell.h"

#include <charconv>
#include <string_view>

namespace plsc {

namespace {

bool IsNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && rest == end;
}

// https://owasp.org/www-community/attacks/CSV_Injection
bool IsFormula(const std::string& text) {
  constexpr std::string_view kBegins = "=+-@\t\r\n";
  return !text.empty() && kBegins.find(text.front()) != kBegins.npos &&
         !IsNumber(text);
}

}  // namespace

std::string CsvCell(const std::string& text) {
  std::string safe = IsFormula(text) ? "'" + text : text;
  if (safe.find_first_of(",\"\r\n") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  return quoted + '"';
}

}  // namespace plsc
