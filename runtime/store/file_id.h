#pragma once

// A file as the system knows it, whatever its names: what may have several
// names (links), and what a name may stop to mean (renamed, deleted, replaced).

#include <sys/stat.h>

#include <compare>
#include <optional>
#include <string>

namespace plsc {

struct FileId {
  dev_t device = 0;
  ino_t inode = 0;

  friend auto operator<=>(const FileId&, const FileId&) = default;
};

inline FileId IdOf(const struct stat& status) {
  return {status.st_dev, status.st_ino};
}

/// Of what the name means, links followed; nothing if it means nothing.
inline std::optional<FileId> FileIdOf(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return IdOf(status);
}

}  // namespace plsc
