#include "runtime/text/csv_cell.h"

#include <catch2/catch.hpp>

namespace plsc {

TEST_CASE("A name is no formula of a spreadsheet", "[csv]") {
  CHECK(CsvCell("=1+1") == "'=1+1");
  CHECK(CsvCell("+cmd|' /C calc'!A0") == "'+cmd|' /C calc'!A0");
  CHECK(CsvCell("-2+3") == "'-2+3");
  CHECK(CsvCell("@SUM(A1)") == "'@SUM(A1)");
  CHECK(CsvCell("\t=1") == "'\t=1");
  CHECK(CsvCell("\r=1") == "\"'\r=1\"");
  CHECK(CsvCell("=HYPERLINK(\"x\",\"y\")") ==
        "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
}

TEST_CASE("Quantities stay numbers, and other texts as they are", "[csv]") {
  for (const char* text : {"-1", "+2", "-1e-3", "-0.5", "-inf", "", "flat",
                           "a=b", "{tilted: 5 deg}", "1-2"})
    CHECK(CsvCell(text) == text);
  CHECK(CsvCell("a,b") == "\"a,b\"");
  CHECK(CsvCell("two\nlines") == "\"two\nlines\"");
}

}  // namespace plsc
