#include "runtime/store/database_file.h"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "tests/runtime/store/stored_run.h"

namespace plsc {

namespace {

namespace fs = std::filesystem;
using test::Scratch;

/// What a process without root's rights says.
std::string AsNobody(const std::function<std::string()>& say) {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setresuid(kNobody, kNobody, kNobody) != 0) _exit(1);
    const std::string said = say();
    if (write(ends[1], said.data(), said.size()) < 0) _exit(1);
    _exit(0);
  }
  close(ends[1]);
  std::string said;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    said.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  CHECK(status == 0);
  return said;
}

/// A folder that others may read and not write, and in it a run that was
/// killed.
void WriteKilled(const Scratch& scratch, const std::vector<std::string>& ends) {
  const Scratch made;
  RunStore store;
  REQUIRE(store.Create(made / "run", test::StoredExperiment()) == std::nullopt);
  REQUIRE(test::Report(test::RecordRun(test::StoredExperiment()), store, 0,
                       2) == "");
  for (const std::string& end : ends)
    fs::copy_file((made / "run") + end, (scratch / "run") + end);
  chmod(scratch.path().c_str(), 0755);
}

std::string ReadAsNobody(const std::string& path) {
  return AsNobody([&] {
    RunStore store;
    if (auto failure = store.OpenForReading(path)) return failure->text;
    const auto saved = store.Load();
    return saved ? std::to_string(saved->generations) : saved.error().text;
  });
}

}  // namespace

TEST_CASE("A killed run in a folder that cannot be written",
          "[database_file]") {
  const Scratch scratch;
  WriteKilled(scratch, {"", "-wal"});
  const std::string path = scratch / "run";
  const std::string said = ReadAsNobody(path);
  CAPTURE(said);
  CHECK(said.find("cannot read '" + path + "'") == 0);
  CHECK(said.find("'" + path + "-shm' must be made") != std::string::npos);
  CHECK(said.find("copy both '" + path + "' and '" + path + "-wal'") !=
        std::string::npos);
  CHECK(scratch.Files() == std::vector<std::string>{"run", "run-wal"});
  // As it says: where it may be written it is read.
  const Scratch other;
  chmod(other.path().c_str(), 0777);
  for (const char* end : {"", "-wal"})
    fs::copy_file(path + end, (other / "run") + end);
  CHECK(ReadAsNobody(other / "run") == "2");
}

TEST_CASE("With its index a killed run is read where nothing can be written",
          "[database_file]") {
  const Scratch scratch;
  WriteKilled(scratch, {"", "-wal", "-shm"});
  CHECK(ReadAsNobody(scratch / "run") == "2");
}

TEST_CASE("A journal that must not be read is named", "[database_file]") {
  const Scratch scratch;
  WriteKilled(scratch, {"", "-wal"});
  const std::string path = scratch / "run";
  chmod((path + "-wal").c_str(), 0600);
  if (geteuid() != 0) return;  // its own file could be read
  const std::string said = ReadAsNobody(path);
  CHECK(said.find("cannot read '" + path + "-wal'") == 0);
  CHECK(said.find("Permission denied") != std::string::npos);
}

TEST_CASE("To go on with a run its folder must be writable",
          "[database_file]") {
  const Scratch scratch;
  const std::string path = scratch / "run";
  test::WriteRun(path, 1);
  chmod(path.c_str(), 0666);
  chmod(scratch.path().c_str(), 0555);
  const std::string said = AsNobody([&] {
    RunStore store;
    return store.Open(path).value_or("").text;
  });
  chmod(scratch.path().c_str(), 0755);
  CAPTURE(said);
  CHECK(said.find("cannot write to '" + path + "'") == 0);
  CHECK(said.find("'" + path + "-wal' must be made beside it") !=
        std::string::npos);
}

}  // namespace plsc
