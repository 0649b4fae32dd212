#pragma once

// A text file that a page and other editors write: what is in it, whether that
// changed, and how to replace it without losing what another editor wrote.
//
// Looked at, not listened to: the system tells of changes in a way of its own
// for every kind of file system, and of some (network folders) not at all,
// while to ask 20 times a second costs 50 microseconds a second.

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>

#include "grammar/failure.h"

namespace plsc::cli {

struct FileState {
  /// Nothing: there is none, or it cannot be read.
  std::optional<std::string> text;
  std::string reason;  ///< why there is no text
  /// Names the content: equal for equal texts, "" where there is none.
  std::string version;

  friend bool operator==(const FileState&, const FileState&) = default;
};

class LiveFile {
 public:
  /// Most bytes of a file, as commands read.
  static constexpr std::size_t kMostBytes = std::size_t{16} << 20U;

  explicit LiveFile(std::string path);

  const std::string& path() const { return path_; }
  /// As last seen.
  const FileState& state() const { return state_; }
  /// Looks again. Whether the state is another one. Files are found by their
  /// name: one that is renamed over it, or made again, is the file.
  bool Look();

  struct Saved {
    /// The file had another content than `base`, which stays: it is in state().
    bool is_conflict = false;
    MaybeFailure failure;  ///< then the file is as it was
  };
  /// Replaces it by `text` as a whole, if its version still is `base` ("": if
  /// there is none).
  Saved Save(const std::string& text, const std::string& base);

 private:
  /// What changes whenever a file's content does.
  struct Mark {
    bool is_there = false;
    dev_t device = 0;
    ino_t file = 0;
    off_t size = 0;
    std::int64_t modified = 0;  // ns
    std::int64_t changed = 0;   // ns

    friend bool operator==(const Mark&, const Mark&) = default;
  };
  Mark ReadMark() const;
  FileState Read() const;

  std::string path_;
  Mark mark_;
  FileState state_;
};

}  // namespace plsc::cli
