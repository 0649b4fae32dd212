// Messages that no good client sends: the server answers each request with a
// result or an error, shows a message for a bad notification, and goes on.

#include <catch2/catch.hpp>
#include <functional>

#include "runtime/lsp/rpc.h"
#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

const std::vector<const char*> kMethods = {
    "initialize",
    "shutdown0",
    "textDocument/codeAction",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/didChange",
    "textDocument/didClose",
    "textDocument/didOpen",
    "textDocument/documentHighlight",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/formatting",
    "textDocument/hover",
    "textDocument/inlayHint",
    "textDocument/prepareRename",
    "textDocument/rangeFormatting",
    "textDocument/references",
    "textDocument/rename",
    "textDocument/semanticTokens/full",
    "textDocument/semanticTokens/range",
    "textDocument/signatureHelp",
    "workspace/didChangeConfiguration",
    "workspace/executeCommand",
};

// A value in the place of each part of well-formed params.
void ForEachBroken(const Json& params, const std::function<void(Json)>& use) {
  const std::vector<Json> wrong = {
      nullptr, true, -1, 1.5, "x", Json::array(), Json::object(), 1e300};
  const Json flat = params.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    for (const Json& one : wrong) {
      Json broken = params;
      broken[Json::json_pointer(pointer)] = one;
      use(broken);
    }
    // Every holder of it, too.
    for (auto holder = Json::json_pointer(pointer).parent_pointer();
         !holder.empty(); holder = holder.parent_pointer())
      for (const Json& one : wrong) {
        Json broken = params;
        broken[holder] = one;
        use(broken);
      }
  }
}

Json GoodParams(const Editor& editor) {
  Json params = editor.Whole();
  params["position"] = {{"line", 10}, {"character", 14}};
  params["newName"] = "fresh";
  params["context"] = {{"only", {"quickfix"}}, {"includeDeclaration", true}};
  params["command"] = "plsc.chooseEnvironment";
  params["arguments"] = Json::array({"flat"});
  params["settings"] = {{"plsc", {{"environment", "flat"}, {"lint", true}}}};
  params["textDocument"]["version"] = 3;
  params["textDocument"]["text"] = kGecko;
  params["contentChanges"] = Json::array(
      {{{"range", params["range"]}, {"text", std::string(kGecko)}}});
  return params;
}

// Whether it still works.
void CheckAlive(Editor& editor) {
  editor.Open(kGecko);
  CHECK(editor.Result("textDocument/documentSymbol", editor.Here()).size() ==
        13);
}

}  // namespace

TEST_CASE("Params of any wrong type are survived", "[lsp][slow]") {
  Editor editor;
  editor.Open(kGecko);
  const Json good = GoodParams(editor);
  for (const char* method : kMethods) {
    INFO(method);
    ForEachBroken(good, [&](const Json& params) {
      // As a request (an answer comes, whatever it is) and a notification.
      editor.Ask(method, params);
      editor.Notify(method, params);
    });
    for (const Json& params :
         {Json(nullptr), Json::array(), Json::array({1}), Json::object()}) {
      editor.Ask(method, params);
      editor.Notify(method, params);
    }
    while (editor.server().has_work()) editor.server().Idle();
    CheckAlive(editor);
  }
}

TEST_CASE("Every place of a text can be asked about", "[lsp]") {
  const std::string texts[] = {kGecko, "", "\r\r\n\n\r",
                               "plsc 1\nrule C -> if a = { \xF0\x9F\xA6\x8E",
                               "plsc 1\n# \xF0\x9F\xA6\x8E\nrule"};
  for (const std::string& text : texts) {
    Editor editor;
    editor.Open(text);
    for (std::uint32_t at = 0; at <= text.size() + 1; ++at)
      for (const char* method :
           {"textDocument/hover", "textDocument/definition",
            "textDocument/completion", "textDocument/prepareRename"})
        editor.Ask(method, editor.HereAt(at));
    for (const std::uint64_t far :
         {std::uint64_t{0xFFFFFFFF}, ~std::uint64_t{0}}) {
      Json params = editor.Here();
      params["position"] = {{"line", far}, {"character", far}};
      CHECK_FALSE(editor.Ask("textDocument/hover", params).contains("error"));
    }
  }
}

TEST_CASE("Unknown documents are refused", "[lsp]") {
  Editor editor;
  const Json answer = editor.Ask("textDocument/hover", editor.HereAt(0));
  CHECK(answer["error"]["code"] == -32602);
  CHECK(answer["error"]["message"] ==
        "no document 'file:///robot.pls' is open");
  editor.Notify("textDocument/didChange", editor.Here());
  CHECK(editor.received().back()["method"] == "window/showMessage");
}

TEST_CASE("A document of 10 MB is looked at", "[lsp][slow]") {
  std::string text = "plsc 1\nalphabet plasticoding 1\n";
  while (text.size() < 10000000)
    text += "rule B -> { add_left B move_left T(0.5) }   # a rule\n";
  Editor editor(Json::object(), {{"lint", false}});
  editor.Open(text);
  // More rules than a genotype may have.
  CHECK(editor.Diagnostics()[0]["code"] == "P3002");
  const auto offset = static_cast<std::uint32_t>(text.size() - 30);
  // Not what answers with megabytes: to read them without optimisation takes
  // half a minute.
  for (const char* method :
       {"textDocument/hover", "textDocument/completion",
        "textDocument/definition", "textDocument/prepareRename"})
    editor.Ask(method, editor.HereAt(offset));
}

TEST_CASE("A text beyond the limit is an error of its own", "[lsp][slow]") {
  Editor editor;
  editor.Open(std::string((std::size_t{16} << 20U) + 1, ' '));
  REQUIRE(editor.Diagnostics().size() == 1);
  CHECK(editor.Diagnostics()[0]["severity"] == 1);
}

TEST_CASE("A flood of requests is answered in order", "[lsp]") {
  Editor editor;
  editor.Open(kGecko);
  for (int i = 0; i < 2000; ++i) {
    editor.Notify("$/cancelRequest", {{"id", i}});
    editor.Ask("textDocument/hover",
               editor.HereAt(static_cast<std::uint32_t>(i % 700)));
  }
  CheckAlive(editor);
}

TEST_CASE("Bodies that are no JSON are answered and survived", "[lsp]") {
  Editor editor;
  for (const std::string& body :
       {std::string(), std::string("{"), std::string("\xFF\xFE"),
        std::string(100000, '{'), std::string("[1,2]"), std::string("null"),
        std::string(
            "{\"id\":1,\"method\":\"a\",\"params\":{\"a\":\"\\ud800\"}}"),
        std::string("{\"jsonrpc\":\"2.0\",\"id\":[],\"method\":\"x\"}")}) {
    const auto answers = editor.server().Handle(body);
    REQUIRE(answers.size() == 1);
    CHECK(Json::parse(answers[0]).contains("error"));
  }
  CheckAlive(editor);
}

}  // namespace plsc::lsp
