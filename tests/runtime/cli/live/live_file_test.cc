#include "runtime/cli/live/live_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <random>
#include <string>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc::cli {
namespace {

namespace fs = std::filesystem;

TEST_CASE("what another editor does to the file is seen", "[live_file]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "one");
  LiveFile file(path);
  CHECK(file.state().text == "one");
  CHECK_FALSE(file.Look());
  // In place, of the same length, within a tick of the clock.
  folder.Write("a.pls", "two");
  CHECK(file.Look());
  CHECK(file.state().text == "two");
  folder.Write("a.pls", "six");
  CHECK(file.Look());
  CHECK(file.state().text == "six");
  // By another file that takes its name.
  folder.Write("b", "new");
  fs::rename(folder / "b", path);
  CHECK(file.Look());
  CHECK(file.state().text == "new");
  // Deleted, and made again.
  fs::remove(path);
  CHECK(file.Look());
  CHECK_FALSE(file.state().text);
  CHECK(file.state().version.empty());
  CHECK(file.state().reason == "No such file or directory");
  CHECK_FALSE(file.Look());
  folder.Write("a.pls", "new");
  CHECK(file.Look());
  CHECK(file.state().text == "new");
  CHECK_FALSE(file.Look());
  // Touched without a change.
  folder.Write("a.pls", "new");
  CHECK_FALSE(file.Look());
}

TEST_CASE("what is no text of a file is said", "[live_file]") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "a.pls");
  CHECK(LiveFile(folder / "a.pls").state().reason == "it is no regular file");
  const std::string big = folder.Write("big", "");
  fs::resize_file(big, LiveFile::kMostBytes + 1);
  CHECK(LiveFile(big).state().reason == "it has more than 16 MiB");
  fs::resize_file(big, LiveFile::kMostBytes);
  CHECK(LiveFile(big).state().text->size() == LiveFile::kMostBytes);
}

TEST_CASE("what was made of the file's text is saved to it", "[live_file]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "one");
  fs::permissions(path, fs::perms(0640));
  fs::create_symlink("a.pls", folder / "link.pls");
  LiveFile file(folder / "link.pls");
  const auto saved = file.Save("two", file.state().version);
  CHECK_FALSE(saved.is_conflict);
  CHECK_FALSE(saved.failure);
  CHECK(test::ReadFile(path) == "two");
  CHECK(file.state().text == "two");
  CHECK_FALSE(file.Look());
  CHECK(fs::is_symlink(folder / "link.pls"));
  CHECK(fs::status(path).permissions() == fs::perms(0640));
  CHECK(folder.Files() == std::vector<std::string>{"a.pls", "link.pls"});
}

TEST_CASE("what another editor wrote in between stays", "[live_file]") {
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "one");
  LiveFile file(path);
  const std::string base = file.state().version;
  folder.Write("a.pls", "theirs");
  CHECK(file.Save("ours", base).is_conflict);
  CHECK(file.state().text == "theirs");
  CHECK(test::ReadFile(path) == "theirs");
  // Whoever has seen it may replace it.
  CHECK_FALSE(file.Save("both", file.state().version).is_conflict);
  CHECK(test::ReadFile(path) == "both");
  // Deletion is a change as well.
  const std::string seen = file.state().version;
  fs::remove(path);
  CHECK(file.Save("ours", seen).is_conflict);
  CHECK_FALSE(fs::exists(path));
  CHECK_FALSE(file.Save("ours", "").is_conflict);
  CHECK(test::ReadFile(path) == "ours");
  CHECK(file.Save("again", "").is_conflict);
  CHECK(test::ReadFile(path) == "ours");
}

TEST_CASE("what cannot be saved leaves the file", "[live_file]") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder / "shut");
  const std::string path = folder.Write("shut/a.pls", "one");
  LiveFile file(path);
  const std::string base = file.state().version;
  fs::permissions(folder / "shut", fs::perms(0500));
  const auto saved = file.Save("two", base);
  fs::permissions(folder / "shut", fs::perms(0700));
  // Root may write everywhere.
  if (saved.failure) {
    CHECK_FALSE(saved.is_conflict);
    CHECK(test::ReadFile(path) == "one");
  }
  CHECK(folder.Files() == std::vector<std::string>{"shut"});
}

// An editor and a page take turns at random; whatever each saw last is what it
// goes on from. Nothing that the editor wrote is lost unless the page saw it.
TEST_CASE("two who write do not lose a text unseen", "[live_file]") {
  const unsigned seed = GENERATE(1U, 2U, 3U, 4U);
  CAPTURE(seed);
  std::mt19937 random(seed);
  const test::TemporaryFolder folder;
  const std::string path = folder.Write("a.pls", "0");
  LiveFile file(path);
  std::string base = file.state().version;
  std::string on_disk = "0";
  std::string seen = "0";
  for (int step = 1; step < 300; ++step) {
    const std::string text = std::to_string(step);
    switch (random() % 4) {
      case 0:  // in place
        folder.Write("a.pls", text);
        on_disk = text;
        break;
      case 1:  // by another file
        folder.Write("b", text);
        fs::rename(folder / "b", path);
        on_disk = text;
        break;
      case 2:
        file.Look();
        CHECK(file.state().text == on_disk);
        base = file.state().version;
        seen = on_disk;
        break;
      default: {
        const bool is_unseen = seen != on_disk;
        const auto saved = file.Save(text, base);
        CHECK_FALSE(saved.failure);
        CHECK(saved.is_conflict == is_unseen);
        if (!saved.is_conflict) {
          on_disk = seen = text;
          base = file.state().version;
        }
        CHECK(test::ReadFile(path) == on_disk);
      }
    }
  }
  CHECK(folder.Files() == std::vector<std::string>{"a.pls"});
}

}  // namespace
}  // namespace plsc::cli
