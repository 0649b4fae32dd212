#include "runtime/store/database_file.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include "runtime/store/file_id.h"
#include "runtime/text/system_reason.h"

namespace plsc {

namespace {

/// 0, or the system's reason.
int AccessError(const std::string& path, int rights) {
  return access(path.c_str(), rights) == 0 ? 0 : errno;
}

int FolderError(const std::string& path) {
  const auto folder = std::filesystem::path(path).parent_path();
  return AccessError(folder.empty() ? "." : folder.string(), W_OK | X_OK);
}

/// What a writer needs beside the file.
MaybeFailure CheckWriting(const std::string& shown) {
  struct stat status {};
  if (stat(shown.c_str(), &status) == 0 && status.st_nlink > 1)
    return fmt::format(
        "cannot write to '{}': the file has {} names (hard links), and under "
        "each it would have another journal: leave it one, or make a copy",
        shown, status.st_nlink);
  if (const int error = FolderError(shown))
    return fmt::format(
        "cannot write to '{0}': its journal '{0}-wal' must be made beside it, "
        "and its folder cannot be written ({1})",
        shown, SystemReason(error));
  return std::nullopt;
}

/// What a reader needs beside the file.
MaybeFailure CheckReading(const std::string& shown) {
  if (HasNoJournal(shown)) return std::nullopt;
  if (const int error = AccessError(shown + "-wal", R_OK))
    return fmt::format("cannot read '{}-wal', which has the newest of '{}': {}",
                       shown, shown, SystemReason(error));
  if (AccessError(shown + "-shm", R_OK) == 0) return std::nullopt;
  const int error = FolderError(shown);
  if (error == 0) return std::nullopt;
  return fmt::format(
      "cannot read '{0}': its newest results are in the journal '{0}-wal' "
      "only, as after a kill; to read that, '{0}-shm' must be made beside it, "
      "and the folder cannot be written ({1}): make it writable, or copy both "
      "'{0}' and '{0}-wal' to one that is",
      shown, SystemReason(error));
}

}  // namespace

std::string RealPath(const std::string& path) {
  char* real = realpath(path.c_str(), nullptr);
  if (real == nullptr) return "";
  std::string text = real;
  free(real);
  return text;
}

std::string PrintablePath(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_symlink(path, error) ? RealPath(path) : path;
}

bool HasNoJournal(const std::string& path) {
  return access((path + "-wal").c_str(), F_OK) != 0;
}

MaybeFailure CheckFile(const std::string& path, bool is_writing) {
  // access, because to open and close the file would drop the locks of another
  // connection of this process.
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    return fmt::format("cannot open '{}': {}", path,
                       SystemReason(error ? error.value() : ENOENT));
  if (std::filesystem::is_directory(status))
    return fmt::format("cannot open '{}': it is a folder", path);
  if (!std::filesystem::is_regular_file(status))
    return fmt::format("cannot open '{}': it is no file", path);
  const int rights = is_writing ? R_OK | W_OK : R_OK;
  if (const int reason = AccessError(path, rights))
    return fmt::format("cannot {} '{}': {}", is_writing ? "write to" : "read",
                       path, SystemReason(reason));
  // SQLite takes an empty file for a database without tables.
  if (std::filesystem::file_size(path, error) == 0)
    return fmt::format("'{}' is empty", path);
  return std::nullopt;
}

MaybeFailure CheckBeside(const std::string& shown, bool is_writing) {
  return is_writing ? CheckWriting(shown) : CheckReading(shown);
}

}  // namespace plsc
