#include "runtime/lsp/code_actions.h"

#include <catch2/catch.hpp>

#include "compiler/apply_fixes.h"
#include "tests/runtime/lsp/editor.h"

namespace plsc::lsp {

namespace {

const char* const kMisspelt =
    "plsc 1\nalphabet plasticoding 1\nsense inclined: bool\n"
    "rule C -> if inclind = True then { C add_frnt B }\n"
    "environment flat { inclined = False }\n";

// The actions for all of a text, after all advice was given.
Json Actions(const std::string& text, Json context = Json::object()) {
  Editor editor;
  editor.Open(text);
  editor.Diagnostics();
  Json params = editor.Whole();
  params["context"] = std::move(context);
  return editor.Result("textDocument/codeAction", params);
}

Json EditsOf(const Json& action) {
  return action["edit"]["changes"][kTestUri];
}

Json WithTitle(const Json& actions, const std::string& title) {
  for (const Json& action : actions)
    if (action["title"] == title) return action;
  FAIL("no action '" << title << "' in " << actions.dump());
  return nullptr;
}

}  // namespace

TEST_CASE("Each fix is an action with its diagnostic", "[lsp]") {
  const Json actions = Actions(kMisspelt);
  const Json action = WithTitle(actions, "Replace 'inclind' by 'inclined'");
  CHECK(action["kind"] == "quickfix");
  CHECK(action["isPreferred"] == true);
  CHECK(action["diagnostics"][0]["code"] == "P2005");
  const std::string mended = Edited(kMisspelt, EditsOf(action));
  CHECK(mended.find("if inclined = True") != std::string::npos);
  CHECK(mended.find("add_frnt") != std::string::npos);
}

TEST_CASE("All that can be mended is one source action", "[lsp]") {
  const Json all = Actions(kMisspelt, {{"only", {"source.fixAll"}}});
  REQUIRE(all.size() == 1);
  CHECK(all[0]["kind"] == "source.fixAll.plsc");
  CHECK(Edited(kMisspelt, EditsOf(all[0])) ==
        MendText(Source("f", kMisspelt)).text);
}

TEST_CASE("Actions are of the kinds that are asked for", "[lsp]") {
  struct Row {
    const char* why;
    Json only;
    bool has_quick;
    bool has_all;
  };
  const std::vector<Row> rows = {
      {"nothing said", nullptr, true, true},
      {"quick fixes", {"quickfix"}, true, false},
      {"all of source", {"source"}, false, true},
      {"another source action", {"source.organizeImports"}, false, false},
      {"a longer name", {"sourc"}, false, false},
      {"no strings", {1, nullptr}, false, false},
      {"no list", "quickfix", true, true},
  };
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      bool has_quick = false;
      bool has_all = false;
      for (const Json& action : Actions(kMisspelt, {{"only", row.only}}))
        (action["kind"] == "quickfix" ? has_quick : has_all) = true;
      CHECK(has_quick == row.has_quick);
      CHECK(has_all == row.has_all);
    }
  }
}

TEST_CASE("Actions belong to the places that are asked about", "[lsp]") {
  Editor editor;
  editor.Open(kMisspelt);
  Json params = editor.Here();
  params["range"] = {{"start", {{"line", 0}, {"character", 0}}},
                     {"end", {{"line", 1}, {"character", 0}}}};
  params["context"] = {{"only", {"quickfix"}}};
  CHECK(editor.Result("textDocument/codeAction", params).empty());
}

TEST_CASE("Advice can be silenced where it is", "[lsp]") {
  for (const std::string text :
       {"plsc 1\nalphabet plasticoding 1\nsense a: bool\n"
        "rule C -> if a = True then { C B }\n",
        "plsc 1\nalphabet plasticoding 1\nsense a: bool "
        "rule C -> if a = True then { C B }\n"}) {
    const Json action = WithTitle(Actions(text), "Allow W3003 here");
    const std::string silenced = Edited(text, EditsOf(action));
    Editor editor;
    editor.Open(silenced);
    for (const Json& one : editor.Diagnostics()) CHECK(one["code"] != "W3003");
  }
}

}  // namespace plsc::lsp
