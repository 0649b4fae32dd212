#include "runtime/cli/live/asker.h"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>
#include <vector>

namespace plsc::cli {
namespace {

/// Answers with how many questions it was asked; some questions kill it, some
/// keep it.
Work Counting() {
  return [count = 0](const std::string& request) mutable {
    if (request.find("crash") != std::string::npos) std::abort();
    while (request.find("endless") != std::string::npos) {
    }
    return std::to_string(++count);
  };
}

struct Desk {
  explicit Desk(double patience = 20)
      : asker({2, patience}, [] { return Counting(); }) {}

  void Ask(const std::string& text, bool is_wanted = true) {
    asker.Ask(
        text,
        [this](server::Response one) { answers.push_back(std::move(one)); },
        [is_wanted] { return is_wanted; });
  }
  void Finish() {
    while (asker.Step()) ::usleep(100);
  }

  Asker asker;
  std::vector<server::Response> answers;
};

TEST_CASE("what editing asks is answered in order, by one memory", "[asker]") {
  Desk desk;
  for (int i = 0; i < 20; ++i) desk.Ask(R"({"ask": "lsp"})");
  desk.Ask("no JSON");
  desk.Finish();
  REQUIRE(desk.answers.size() == 21);
  for (int i = 0; i < 21; ++i)
    CHECK(desk.answers[static_cast<std::size_t>(i)].body ==
          std::to_string(i + 1));
}

TEST_CASE("a life that never ends keeps nobody from editing", "[asker]") {
  Desk desk(0.2);
  desk.Ask(R"({"ask": "live", "text": "endless"})");
  desk.Ask(R"({"ask": "live", "text": "endless"})");
  desk.asker.Step();
  desk.Ask(R"({"ask": "check"})");
  while (desk.answers.empty()) desk.asker.Step();
  CHECK(desk.answers.front().body == "1");
  desk.Finish();
  REQUIRE(desk.answers.size() == 3);
  CHECK(desk.answers[1].status == 200);
  CHECK(
      desk.answers[1].body ==
      R"({"ok":false,"error":"it could not be computed: no answer for 0.2 s"})");
  // Others are there to go on with.
  desk.Ask(R"({"ask": "live"})");
  desk.Finish();
  CHECK(desk.answers[3].body == "1");
}

TEST_CASE("a question that kills is answered, and its successor too",
          "[asker]") {
  Desk desk;
  desk.Ask(R"({"ask": "lsp", "text": "crash"})");
  desk.Ask(R"({"ask": "lsp"})");
  desk.Finish();
  REQUIRE(desk.answers.size() == 2);
  CHECK(desk.answers[0].status == 200);
  CHECK(desk.answers[0].body.find("signal 6") != std::string::npos);
  CHECK(desk.answers[1].body == "1");
}

TEST_CASE("what nobody waits for is not begun", "[asker]") {
  Desk desk;
  desk.Ask(R"({"ask": "lsp", "text": "crash"})", false);
  desk.Ask(R"({"ask": "lsp"})");
  desk.Finish();
  REQUIRE(desk.answers.size() == 1);
  CHECK(desk.answers[0].body == "1");
}

}  // namespace
}  // namespace plsc::cli
