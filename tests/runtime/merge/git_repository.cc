#include "tests/runtime/merge/git_repository.h"

#include <sys/wait.h>

#include <cstdlib>
#include <stdexcept>

namespace plsc::test {

namespace {

// Nothing of the user's own configuration, and always the same author and
// date.
constexpr const char* kGit =
    "env GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null "
    "GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b GIT_COMMITTER_NAME=a "
    "GIT_COMMITTER_EMAIL=a@b GIT_AUTHOR_DATE='2026-01-01 00:00 +0000' "
    "GIT_COMMITTER_DATE='2026-01-01 00:00 +0000' LC_ALL=C git ";

}  // namespace

bool HasGit() {
  return std::system("git --version > /dev/null 2>&1") == 0;
}

GitRepository::GitRepository(bool has_driver) {
  Git("init -q -b main .");
  const std::string plsc = PLSC_EXECUTABLE;
  Git("config diff.plsc.command '" + plsc + " diff --git --'");
  if (!has_driver) return;
  Git("config merge.plsc.name 'genotypes by rule and symbol'");
  Git("config merge.plsc.driver '" + plsc +
      " merge --driver -L %L --path=%P -- %O %A %B'");
  Write(".gitattributes", "*.pls diff=plsc merge=plsc\n");
}

Ran GitRepository::Git(const std::string& words) const {
  TemporaryFolder outputs;
  const std::string command = "cd '" + folder_.path().string() + "' && " +
                              kGit + words + " > '" + (outputs / "out") +
                              "' 2> '" + (outputs / "err") + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          ReadFile(outputs / "out"), ReadFile(outputs / "err")};
}

void GitRepository::Commit(const std::string& message) const {
  Git("add -A");
  const Ran ran = Git("commit -q --allow-empty -m '" + message + "'");
  if (ran.exit != 0) throw std::runtime_error(ran.err);
}

}  // namespace plsc::test
