#include "runtime/cli/files/open_run.h"

#include <catch2/catch.hpp>

#include "tests/runtime/cli/tiny_run.h"

namespace plsc {
namespace {

TEST_CASE("individuals are named by number, or best", "[open_run]") {
  RunStore store;
  REQUIRE_FALSE(store.OpenForReading(test::FinishedRun().path()));
  CHECK(*cli::IdOf(store, "7") == 7);
  const int best = test::FinishedRun().summary()["best"]["id"];
  CHECK(*cli::IdOf(store, "best") == best);
  for (const char* name : {"", "0", "-1", "7x", "x", "1e3", "99999999999"}) {
    INFO(name);
    const Expected<int, Failure> id = cli::IdOf(store, name);
    CHECK_FALSE(id);
    CHECK(id.error().text.find("expected the number of a robot") !=
          std::string::npos);
  }
  CHECK(*cli::IdsOf(store, {}) == std::vector<int>{best});
  CHECK(*cli::IdsOf(store, {"3", "1"}) == std::vector<int>{3, 1});
  CHECK_FALSE(cli::IdsOf(store, {"3", "none"}));
  CHECK(cli::EvaluatedIds(store)->size() == 18);
}

TEST_CASE("a run without a generation has no best", "[open_run]") {
  const test::TemporaryFolder folder;
  RunStore store;
  REQUIRE_FALSE(store.Create(folder / "run", Experiment{}));
  CHECK(cli::IdOf(store, "best").error().text.find("no generation") !=
        std::string::npos);
  CHECK(cli::EvaluatedIds(store).error().text.find("nobody") !=
        std::string::npos);
}

TEST_CASE("a database is known by its first bytes", "[open_run]") {
  const test::TemporaryFolder folder;
  const std::string magic("SQLite format 3\0", 16);
  CHECK(cli::IsDatabase(test::FinishedRun().path()));
  CHECK(cli::IsDatabase(folder.Write("any.name", magic + "rest")));
  CHECK_FALSE(cli::IsDatabase(folder.Write("cut.sqlite", magic.substr(0, 15))));
  CHECK_FALSE(cli::IsDatabase(folder.Write("text.sqlite", "SQLite format 31")));
  CHECK_FALSE(cli::IsDatabase(folder.Write("empty.sqlite", "")));
  CHECK_FALSE(cli::IsDatabase(folder / "none.sqlite"));
  CHECK_FALSE(cli::IsDatabase(folder.path().string()));
}

}  // namespace
}  // namespace plsc
