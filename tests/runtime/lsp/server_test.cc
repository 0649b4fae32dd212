#include "runtime/lsp/server.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

std::string Body(const char* method, Json params, int id = 0) {
  Json body = {{"jsonrpc", "2.0"}, {"method", method}};
  if (!params.is_null()) body["params"] = std::move(params);
  if (id != 0) body["id"] = id;
  return body.dump();
}

int ErrorOf(Server& server, const std::string& body) {
  const auto bodies = server.Handle(body);
  REQUIRE(bodies.size() == 1);
  const Json answer = Json::parse(bodies[0]);
  if (!answer.contains("error")) return 0;
  return answer["error"]["code"].get<int>();
}

}  // namespace

TEST_CASE("A session begins and ends as LSP says", "[lsp]") {
  Server server("test");
  CHECK(ErrorOf(server, Body("textDocument/hover", Json::object(), 1)) ==
        -32002);
  // Notifications before initialize are dropped.
  CHECK(server.Handle(Body("textDocument/didOpen", Json::object())).empty());
  CHECK(ErrorOf(server, Body("initialize", nullptr, 2)) == -32602);
  CHECK(ErrorOf(server, Body("initialize", Json::object(), 3)) == 0);
  CHECK(ErrorOf(server, Body("initialize", Json::object(), 4)) == -32600);
  CHECK(server.Handle(Body("initialized", Json::object())).empty());
  CHECK(server.Handle(Body("$/cancelRequest", {{"id", 3}})).empty());
  CHECK(server.Handle(Body("$/unknown", nullptr)).empty());
  CHECK(ErrorOf(server, Body("$/unknown", nullptr, 5)) == -32601);
  CHECK(ErrorOf(server, Body("unknown", nullptr, 6)) == -32601);
  CHECK(ErrorOf(server, Body("shutdown", nullptr, 7)) == 0);
  CHECK(ErrorOf(server, Body("textDocument/hover", Json::object(), 8)) ==
        -32600);
  CHECK_FALSE(server.exit_status());
  server.Handle(Body("exit", nullptr));
  CHECK(server.exit_status() == 0);
}

TEST_CASE("An exit without a shutdown is a failure", "[lsp]") {
  Server fresh("test");
  fresh.Handle(Body("exit", nullptr));
  CHECK(fresh.exit_status() == 1);
  Editor editor;
  editor.Notify("exit", nullptr);
  CHECK(editor.server().exit_status() == 1);
}

TEST_CASE("Diagnostics follow each keystroke", "[lsp]") {
  Editor editor;
  editor.Open("plsc 1\nalphabet plasticoding 1\nrule C -> { C }\n");
  CHECK(editor.Diagnostics().empty());
  const auto type = [&](const char* text, int from, int to, int version) {
    Json change = {{"text", text}};
    change["range"] = {{"start", {{"line", 2}, {"character", from}}},
                       {"end", {{"line", 2}, {"character", to}}}};
    Json params = {{"textDocument", {{"uri", kTestUri}, {"version", version}}}};
    params["contentChanges"] = Json::array({change});
    editor.Notify("textDocument/didChange", params);
  };
  type("Q", 12, 13, 2);
  const Json broken = editor.Diagnostics();
  REQUIRE(broken.size() == 1);
  CHECK(broken[0]["code"] == "P2001");
  CHECK(editor.received().back()["params"]["version"] == 2);
  type("C", 12, 13, 3);
  CHECK(editor.Diagnostics().empty());
}

TEST_CASE("Only the last of several changes is looked at", "[lsp]") {
  Editor editor;
  for (int i = 0; i < 100; ++i) editor.Open("plsc 1\n");
  CHECK(editor.received().empty());
  editor.Diagnostics();
  CHECK(editor.received().size() == 1);
}

TEST_CASE("Advice comes after the diagnostics, unless it is off", "[lsp]") {
  const std::string text =
      "plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
      "rule C -> if a = True then { C B }\n";
  Editor editor;
  editor.Open(text);
  CHECK(editor.Diagnostics()[0]["code"] == "W3003");
  REQUIRE(editor.received().size() == 2);
  CHECK(editor.received()[0]["params"]["diagnostics"].empty());
  editor.Notify("workspace/didChangeConfiguration",
                {{"settings", {{"plsc", {{"lint", false}}}}}});
  CHECK(editor.Diagnostics().empty());

  Editor quiet(Json::object(), {{"lint", false}});
  quiet.Open(text);
  CHECK(quiet.Diagnostics().empty());
}

TEST_CASE("A closed document has no diagnostics", "[lsp]") {
  Editor editor;
  editor.Open("nothing");
  CHECK_FALSE(editor.Diagnostics().empty());
  editor.Notify("textDocument/didClose", editor.Here());
  CHECK(editor.Diagnostics().empty());
  CHECK(editor.Ask("textDocument/hover", editor.HereAt(0))["error"]["code"] ==
        -32602);
}

TEST_CASE("Settings of other servers are ignored", "[lsp]") {
  Editor editor;
  editor.Notify("workspace/didChangeConfiguration",
                {{"settings", {{"other", 1}}}});
  editor.Notify("workspace/didChangeConfiguration", {{"settings", nullptr}});
  CHECK(editor.received().empty());
}

}  // namespace plsc::lsp
