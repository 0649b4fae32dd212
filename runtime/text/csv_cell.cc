#include "runtime/text/csv_cell.h"

#include <string_view>

#include "grammar/number.h"

namespace plsc {

namespace {

bool IsNumber(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const LeadingNumber<double> number = ReadNumber<double>(text);  // or inf
  return number.kind == LeadingNumber<double>::Kind::kFits &&
         number.length == text.size();
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
