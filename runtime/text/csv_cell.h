#pragma once

// Texts in tables with commas.

#include <string>

namespace plsc {

/// As RFC 4180 quotes it. What a spreadsheet would run as a formula, as a name
/// that begins with one of = + - @ or a control character, is led by an
/// apostrophe, the spreadsheets' own sign for text; numbers stay as they are.
std::string CsvCell(const std::string& text);

}  // namespace plsc
