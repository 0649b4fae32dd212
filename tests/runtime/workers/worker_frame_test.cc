#include "runtime/workers/worker_frame.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <vector>

namespace plsc {

TEST_CASE("A frame arrives in any pieces", "[worker_frame]") {
  const std::string zeros("a\0b\0", 4);
  for (const std::string& text : {std::string(), zeros, std::string(500, 'x')})
    for (const std::size_t piece : {1u, 7u, 16u, 17u, 1000u}) {
      CAPTURE(text, piece);
      const std::string frame = Frame(text);
      FrameReader reader;
      for (std::size_t i = 0; i < frame.size(); i += piece) {
        CHECK_FALSE(reader.Take());
        reader.Append(std::string_view(frame).substr(i, piece));
      }
      CHECK(reader.Take() == text);
      CHECK_FALSE(reader.is_broken());
      // Ready for the next.
      CHECK_FALSE(reader.Take());
      reader.Append(frame);
      CHECK(reader.Take() == text);
    }
}

TEST_CASE("What is no frame is seen", "[worker_frame]") {
  std::string endless = Frame("");
  std::memset(endless.data() + 8, 0xff, 8);
  struct Row {
    const char* why;
    std::string bytes;
    bool is_broken;
  };
  const std::vector<Row> rows = {
      {"another mark", std::string(100, 'x'), true},
      {"too long to be meant", endless, true},
      {"two at once", Frame("a") + Frame("b"), true},
      {"a byte too many", Frame("a") + "x", true},
      {"too short to tell", "xxx", false},
      {"half of one", Frame("ab").substr(0, 17), false},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      FrameReader reader;
      reader.Append(row.bytes);
      CHECK(reader.is_broken() == row.is_broken);
      CHECK_FALSE(reader.Take());
    }
  }
}

}  // namespace plsc
