#include "runtime/store/new_file.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;
using test::ReadBytes;
using test::Scratch;
using test::WriteBytes;
using Files = std::vector<std::string>;

const NewFile::Until kBoth[] = {NewFile::Until::kNameless,
                                NewFile::Until::kNamed};

}  // namespace

TEST_CASE("A new file has its name when it is whole", "[new_file]") {
  for (const auto until : kBoth) {
    const Scratch scratch;
    const std::string text(200'000, 'x');
    {
      NewFile file(scratch / "new", until);
      REQUIRE(file.Write(text) == std::nullopt);
      REQUIRE(file.Write("end") == std::nullopt);
      CHECK_FALSE(fs::exists(scratch / "new"));
      REQUIRE(file.Publish() == std::nullopt);
      CHECK(scratch.Files() == Files{"new"});
    }
    CHECK(scratch.Files() == Files{"new"});
    CHECK(ReadBytes(scratch / "new") == text + "end");
    const mode_t mask = umask(0);
    umask(mask);
    struct stat status {};
    REQUIRE(stat((scratch / "new").c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == (0666 & ~mask));
    // Of one that was not finished nothing is left.
    { CHECK(NewFile(scratch / "other", until).Write("a") == std::nullopt); }
    CHECK(scratch.Files() == Files{"new"});
  }
}

TEST_CASE("What is there is kept by Publish, and replaced by Replace",
          "[new_file]") {
  for (const auto until : kBoth) {
    const Scratch scratch;
    WriteBytes(scratch / "victim", "kept");
    WriteBytes(scratch / "file", "old");
    fs::create_symlink("victim", scratch / "link");
    fs::create_symlink("nothing", scratch / "nowhere");
    for (const char* name : {"file", "link", "nowhere"}) {
      NewFile file(scratch / name, until);
      REQUIRE(file.Write("new") == std::nullopt);
      CHECK(file.Publish() ==
            "cannot write to '" + (scratch / name) + "': File exists");
    }
    CHECK(ReadBytes(scratch / "file") == "old");
    for (const char* name : {"file", "link"}) {
      NewFile file(scratch / name, until);
      REQUIRE(file.Write("new") == std::nullopt);
      REQUIRE(file.Replace() == std::nullopt);
      CHECK(ReadBytes(scratch / name) == "new");
    }
    CHECK_FALSE(fs::is_symlink(scratch / "link"));
    CHECK(ReadBytes(scratch / "victim") == "kept");
    CHECK(scratch.Files() == Files{"file", "link", "nowhere", "victim"});
  }
}

TEST_CASE("A name that is planted beside a new file is not used",
          "[new_file]") {
  const Scratch scratch;
  WriteBytes(scratch / "victim", "kept");
  const std::string first = "new." + std::to_string(getpid()) + ".0.new";
  fs::create_symlink("victim", scratch / first);
  {
    NewFile file(scratch / "new", NewFile::Until::kNamed);
    REQUIRE(file.Write("text") == std::nullopt);
    REQUIRE(file.Replace() == std::nullopt);
  }
  CHECK(ReadBytes(scratch / "victim") == "kept");
  CHECK(fs::is_symlink(scratch / first));
  CHECK(scratch.Files() == Files{"new", first, "victim"});
}

TEST_CASE("What cannot be written is told, and nothing is left", "[new_file]") {
  for (const auto until : kBoth) {
    const Scratch scratch;
    NewFile nowhere(scratch / "none/new", until);
    CHECK(nowhere.Publish() == "cannot write to '" + (scratch / "none/new") +
                                   "': No such file or directory");
    struct rlimit before {};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    const struct rlimit small = {1000, before.rlim_max};
    MaybeFailure failure;
    {
      NewFile file(scratch / "new", until);
      setrlimit(RLIMIT_FSIZE, &small);
      failure = file.Write(std::string(5000, 'x'));
      if (!failure) failure = file.Publish();
      setrlimit(RLIMIT_FSIZE, &before);
    }
    signal(SIGXFSZ, handler);
    CHECK(failure ==
          "cannot write to '" + (scratch / "new") + "': File too large");
    CHECK(scratch.Files().empty());
  }
}

}  // namespace plsc
