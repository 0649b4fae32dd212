#include "runtime/cli/files/line_reader.h"

#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <sstream>
#include <string_view>
#include <vector>

namespace plsc {
namespace {

using cli::InputLine;
using cli::LineReader;

/// Streams of which only `in` matters.
struct Streams {
  explicit Streams(const std::string& text) : in(text) {}
  std::istringstream in;
  std::ostringstream out;
  cli::Io io{in, out, out};
};

std::vector<InputLine> AllOf(LineReader& reader) {
  std::vector<InputLine> lines;
  while (!reader.is_at_end()) {
    reader.Fill(0);
    while (reader.has_line()) lines.push_back(*reader.Next());
  }
  return lines;
}

TEST_CASE("Lines of a stream come with their numbers", "[line_reader]") {
  struct Row {
    const char* why;
    const char* text;
    std::vector<std::string> lines;
  };
  const std::vector<Row> rows = {
      {"nothing", "", {}},
      {"one", "a\n", {"a"}},
      {"the last one without its end", "a\nb", {"a", "b"}},
      {"empty ones", "\n\nc\n", {"", "", "c"}},
  };
  for (const Row& row : rows) {
    INFO(row.why);
    Streams streams(row.text);
    LineReader reader(streams.io);
    const auto lines = AllOf(reader);
    REQUIRE(lines.size() == row.lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      CHECK(lines[i].number == i + 1);
      CHECK(lines[i].text == row.lines[i]);
      CHECK_FALSE(lines[i].is_cut);
    }
  }
}

TEST_CASE("A line is cut at the limit, and the next one is whole",
          "[line_reader]") {
  Streams streams("12345\n123456789\n\nabcdef");
  LineReader reader(streams.io, 5);
  const auto lines = AllOf(reader);
  REQUIRE(lines.size() == 4);
  CHECK_FALSE(lines[0].is_cut);
  CHECK(lines[1].text == "12345");
  CHECK(lines[1].is_cut);
  CHECK(lines[2].text.empty());
  CHECK_FALSE(lines[2].is_cut);
  CHECK(lines[3].text == "abcde");
  CHECK(lines[3].is_cut);
}

TEST_CASE("A line longer than a buffer is whole", "[line_reader]") {
  const std::string longer(200000, 'x');
  Streams streams(longer + "\n" + longer);
  LineReader reader(streams.io);
  const auto lines = AllOf(reader);
  REQUIRE(lines.size() == 2);
  CHECK(lines[0].text == longer);
  CHECK(lines[1].text == longer);
}

TEST_CASE("A pipe gives what is there and does not hold up", "[line_reader]") {
  std::array<int, 2> ends{};
  REQUIRE(pipe(ends.data()) == 0);
  Streams streams("");
  streams.io.input_descriptor = ends[0];
  LineReader reader(streams.io);
  const auto send = [&](std::string_view text) {
    REQUIRE(write(ends[1], text.data(), text.size()) ==
            static_cast<ssize_t>(text.size()));
  };
  reader.Fill(0);
  CHECK_FALSE(reader.has_line());
  send("begun");
  reader.Fill(0);
  CHECK_FALSE(reader.has_line());
  send(" and ended\nnext");
  reader.Fill(0);
  REQUIRE(reader.has_line());
  CHECK(reader.Next()->text == "begun and ended");
  CHECK_FALSE(reader.Next());
  CHECK_FALSE(reader.is_at_end());
  close(ends[1]);
  reader.Fill(-1);
  REQUIRE(reader.has_line());
  CHECK_FALSE(reader.is_at_end());
  CHECK(reader.Next()->text == "next");
  CHECK(reader.is_at_end());
  close(ends[0]);
}

}  // namespace
}  // namespace plsc
