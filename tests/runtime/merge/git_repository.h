#pragma once

// A repository of the real git in a folder of its own, with plsc as diff and
// merge driver, as docs/git.md sets it up.

#include <string>

#include "tests/runtime/cli/run_plsc.h"

namespace plsc::test {

/// Whether `git` is there; without it tests of it are left out.
bool HasGit();

class GitRepository {
 public:
  /// Without plsc as merge driver git merges by lines.
  explicit GitRepository(bool has_driver = true);

  std::string Path(const std::string& name) const { return folder_ / name; }
  void Write(const std::string& name, const std::string& text) const {
    folder_.Write(name, text);
  }
  std::string Read(const std::string& name) const {
    return ReadFile(folder_ / name);
  }
  /// `git WORDS...`; the words are written for a shell.
  Ran Git(const std::string& words) const;
  /// Commits all that is there.
  void Commit(const std::string& message) const;

 private:
  TemporaryFolder folder_;
};

}  // namespace plsc::test
