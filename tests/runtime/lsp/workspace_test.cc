#include "runtime/lsp/workspace.h"

#include <catch2/catch.hpp>

namespace plsc::lsp {

TEST_CASE("Settings are taken where they are right", "[lsp]") {
  Workspace workspace;
  CHECK(TakeSettings({{"environment", "flat"}}, &workspace));
  CHECK(workspace.settings.environment == "flat");
  CHECK_FALSE(TakeSettings({{"environment", "flat"}}, &workspace));
  CHECK_FALSE(TakeSettings({{"environment", 7}, {"lint", "no"}}, &workspace));
  CHECK_FALSE(TakeSettings("flat", &workspace));
  CHECK_FALSE(TakeSettings(nullptr, &workspace));
  CHECK(TakeSettings({{"lint", false}}, &workspace));
  CHECK_FALSE(workspace.settings.lint);
  CHECK(workspace.settings.environment == "flat");
}

TEST_CASE("Only clients that can are asked to refresh", "[lsp]") {
  Workspace workspace;
  workspace.RefreshHints();
  CHECK(workspace.outgoing.empty());
  workspace.client.can_refresh_hints = true;
  workspace.RefreshHints();
  workspace.RefreshHints();
  REQUIRE(workspace.outgoing.size() == 2);
  CHECK(Json::parse(workspace.outgoing[0])["id"] !=
        Json::parse(workspace.outgoing[1])["id"]);
}

}  // namespace plsc::lsp
