#include "runtime/lsp/commands.h"

#include <catch2/catch.hpp>

#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

Json Command(const char* command, Json arguments) {
  Json params = {{"command", command}};
  params["arguments"] = std::move(arguments);
  return params;
}

const Json kRefreshes = {
    {"workspace", {{"inlayHint", {{"refreshSupport", true}}}}}};

std::string FirstHint(Editor& editor) {
  return editor.Result("textDocument/inlayHint", editor.Whole())[0]["label"];
}

}  // namespace

TEST_CASE("The environment of hints can be chosen", "[lsp]") {
  Editor editor(kRefreshes);
  editor.Open(kGecko);
  CHECK(FirstHint(editor) == "active, joined 1 of 2");
  CHECK(editor
            .Result("workspace/executeCommand",
                    Command(kChooseEnvironment, {"tilted"}))
            .is_null());
  REQUIRE_FALSE(editor.received().empty());
  CHECK(editor.received().back()["method"] == "workspace/inlayHint/refresh");
  CHECK(editor.received().back().contains("id"));
  CHECK(FirstHint(editor) == "inactive");
  editor.Result("workspace/executeCommand",
                Command(kChooseEnvironment, Json::array()));
  CHECK(FirstHint(editor) == "active, joined 1 of 2");
}

TEST_CASE("An environment that no genotype has is refused", "[lsp]") {
  Editor editor;
  editor.Open(kGecko);
  const Json answer = editor.Ask("workspace/executeCommand",
                                 Command(kChooseEnvironment, {"nowhere"}));
  CHECK(answer["error"]["code"] == -32803);
  CHECK(FirstHint(editor) == "active, joined 1 of 2");
}

TEST_CASE("Environments are listed for a menu", "[lsp]") {
  Editor editor;
  editor.Open(kGecko);
  CHECK(editor.Result("workspace/executeCommand",
                      Command(kListEnvironments, {kTestUri})) ==
        Json({"flat", "tilted"}));
}

TEST_CASE("Commands of the wrong kind are refused", "[lsp]") {
  Editor editor;
  for (const Json& params :
       {Command("other", {"x"}), Command(kChooseEnvironment, {7}),
        Command(kChooseEnvironment, {{"a", 1}}),
        Command(kListEnvironments, {"file:///closed.pls"}), Json::object()}) {
    INFO(params.dump());
    CHECK(editor.Ask("workspace/executeCommand", params)["error"]["code"] ==
          -32602);
  }
}

}  // namespace plsc::lsp
