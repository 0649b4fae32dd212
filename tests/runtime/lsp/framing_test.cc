#include "runtime/lsp/framing.h"

#include <catch2/catch.hpp>
#include <vector>

namespace plsc::lsp {

using Kind = Frame::Kind;

TEST_CASE("Bodies come out however the bytes come in", "[lsp]") {
  const std::string bytes = FrameMessage("{}") + FrameMessage("") +
                            "content-length:  3 \r\nContent-Type: x\n\r\n[1]";
  for (std::size_t step = 1; step <= bytes.size(); ++step) {
    FrameReader reader;
    std::vector<std::string> bodies;
    for (std::size_t at = 0; at < bytes.size(); at += step) {
      reader.Append(std::string_view(bytes).substr(at, step));
      for (Frame frame = reader.Next(); frame.kind == Kind::kBody;
           frame = reader.Next())
        bodies.push_back(frame.text);
    }
    CHECK(reader.Next().kind == Kind::kIncomplete);
    CHECK(bodies == std::vector<std::string>{"{}", "", "[1]"});
  }
}

TEST_CASE("A message has its length in bytes", "[lsp]") {
  CHECK(FrameMessage("\xC3\xA9") == "Content-Length: 2\r\n\r\n\xC3\xA9");
}

TEST_CASE("Headers that cannot be read end everything", "[lsp]") {
  struct Row {
    const char* why;
    std::string bytes;
  };
  const std::vector<Row> rows = {
      {"no header at all", "{\"jsonrpc\":\"2.0\"}\n"},
      {"no length", "Content-Type: x\r\n\r\n{}"},
      {"negative", "Content-Length: -1\r\n\r\n"},
      {"no number", "Content-Length: ten\r\n\r\n"},
      {"empty", "Content-Length:\r\n\r\n"},
      {"a plus", "Content-Length: +3\r\n\r\n"},
      {"a rest", "Content-Length: 3x\r\n\r\n"},
      {"beyond the limit", "Content-Length: 67108865\r\n\r\n"},
      {"beyond 64 bits", "Content-Length: 99999999999999999999999\r\n\r\n"},
      {"a header without end", std::string(kMaxHeaderBytes + 1, 'x')},
      {"many header lines",
       [] {
         std::string lines;
         while (lines.size() <= kMaxHeaderBytes) lines += "a: b\r\n";
         return lines;
       }()},
      {"zero bytes", std::string(10, '\0') + "\n"},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      FrameReader reader;
      reader.Append(row.bytes);
      const Frame frame = reader.Next();
      CHECK(frame.kind == Kind::kBroken);
      CHECK(frame.text.starts_with("expected"));
      reader.Append(FrameMessage("{}"));
      CHECK(reader.Next().kind == Kind::kBroken);
    }
  }
}

TEST_CASE("A body that does not come is waited for", "[lsp]") {
  FrameReader reader;
  reader.Append("Content-Length: 10\r\n\r\n{");
  CHECK(reader.Next().kind == Kind::kIncomplete);
  CHECK(reader.Next().kind == Kind::kIncomplete);
}

TEST_CASE("A flood of messages is read without its square in time", "[lsp]") {
  // Moving all bytes for each message would be 10^11 moves.
  FrameReader reader;
  std::string flood;
  for (int i = 0; i < 20000; ++i) flood += FrameMessage(std::string(200, 'x'));
  reader.Append(flood);
  int count = 0;
  while (reader.Next().kind == Kind::kBody) ++count;
  CHECK(count == 20000);
}

}  // namespace plsc::lsp
