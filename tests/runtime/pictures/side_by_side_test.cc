#include "runtime/pictures/side_by_side.h"

#include <catch2/catch.hpp>

namespace plsc {
namespace {

TEST_CASE("as many blocks stand beside each other as fit", "[side_by_side]") {
  const std::vector<std::string> blocks{"a\nbbb\n", "┌┐\n└┘\nx\n", "c\n"};
  struct Row {
    const char* why;
    std::size_t columns;
    const char* text;
  };
  const std::vector<Row> rows = {
      {"all", 80, "a     ┌┐   c\nbbb   └┘\n      x\n"},
      {"just", 12, "a     ┌┐   c\nbbb   └┘\n      x\n"},
      {"two", 11, "a     ┌┐\nbbb   └┘\n      x\n\nc\n"},
      {"one at least", 0, "a\nbbb\n\n┌┐\n└┘\nx\n\nc\n"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      CHECK(SideBySide(blocks, row.columns) == row.text);
    }
  }
  CHECK(SideBySide({}, 80).empty());
}

}  // namespace
}  // namespace plsc
