// The language server as a command: bytes in, bytes out, exit status.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runtime/lsp/framing.h"
#include "tests/runtime/cli/run_plsc.h"

namespace plsc::test {

namespace {

using Json = nlohmann::json;
using lsp::FrameMessage;

std::string MessageBody(const char* method, Json params = nullptr, int id = 0) {
  Json body = {{"jsonrpc", "2.0"}, {"method", method}};
  if (!params.is_null()) body["params"] = std::move(params);
  if (id > 0) body["id"] = id;
  return FrameMessage(body.dump());
}

std::string Opened(const std::string& text) {
  Json document = {{"uri", "file:///a.pls"}, {"version", 1}};
  document["text"] = text;
  return MessageBody("textDocument/didOpen", {{"textDocument", document}});
}

const std::string kHello =
    MessageBody("initialize", {{"capabilities", Json::object()}}, 1);
const std::string kGoodbye =
    MessageBody("shutdown", nullptr, 9) + MessageBody("exit");

std::vector<Json> Messages(const std::string& bytes) {
  lsp::FrameReader reader;
  reader.Append(bytes);
  std::vector<Json> messages;
  for (lsp::Frame frame = reader.Next(); frame.kind == lsp::Frame::Kind::kBody;
       frame = reader.Next())
    messages.push_back(Json::parse(frame.text));
  CHECK(reader.Next().kind == lsp::Frame::Kind::kIncomplete);
  return messages;
}

}  // namespace

TEST_CASE("A session ends with status 0", "[cli]") {
  const Ran ran = RunPlsc({"lsp"}, kHello + kGoodbye);
  CHECK(ran.exit == 0);
  CHECK(ran.err.empty());
  const auto messages = Messages(ran.out);
  REQUIRE(messages.size() == 2);
  CHECK(messages[0]["result"]["serverInfo"]["name"] == "plsc");
  CHECK(messages[1]["result"].is_null());
}

TEST_CASE("Diagnostics come when nothing else waits", "[cli]") {
  // The end of input, like a pause, is time for what waits.
  const Ran ran = RunPlsc({"lsp"}, kHello + Opened("plsc 1\nrule"));
  CHECK(ran.exit == 1);
  const auto messages = Messages(ran.out);
  REQUIRE(messages.size() == 2);
  CHECK(messages[1]["method"] == "textDocument/publishDiagnostics");
  CHECK_FALSE(messages[1]["params"]["diagnostics"].empty());
}

TEST_CASE("A client that never pauses is told, too", "[cli]") {
  std::string flood = kHello;
  for (int i = 0; i < 200; ++i) flood += Opened("plsc 1\nrule");
  const auto messages = Messages(RunPlsc({"lsp"}, flood + kGoodbye).out);
  // Some, and by far not all.
  CHECK(messages.size() > 3);
  CHECK(messages.size() < 20);
}

TEST_CASE("A client that breaks off or breaks the protocol is status 1",
          "[cli]") {
  for (const std::string& input :
       {std::string(), kHello, kHello + "Content-Length: 5\r\n\r\n{",
        kHello + MessageBody("exit")}) {
    const Ran ran = RunPlsc({"lsp"}, input);
    CHECK(ran.exit == 1);
    CHECK(ran.err.empty());
  }
  const Ran broken = RunPlsc({"lsp"}, "hello\n");
  CHECK(broken.exit == 1);
  CHECK(Messages(broken.out)[0]["error"]["code"] == -32700);
}

TEST_CASE("What clients say to every server is accepted", "[cli]") {
  CHECK(RunPlsc({"lsp", "--stdio"}, kHello + kGoodbye).exit == 0);
  CHECK(RunPlsc({"lsp", "--stdio", "--clientProcessId=7"}, kHello + kGoodbye)
            .exit == 0);
  CHECK(RunPlsc({"lsp", "--port", "7"}).exit == 2);
  CHECK(RunPlsc({"lsp", "file.pls"}).exit == 2);
  CHECK(RunPlsc({"lsp", "--help"}).out.find("docs/editors/README.md") !=
        std::string::npos);
}

}  // namespace plsc::test
