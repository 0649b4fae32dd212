// The neighbour is opened exclusively: what has its name already is not ours.
// It is flushed to the disk before it takes the file's name, else a power cut
// could leave the name with half of the bytes.

#include "runtime/cli/files/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <sstream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/text/system_reason.h"

namespace plsc::cli {

namespace {

constexpr std::size_t kBuffer = 1 << 16;  // bytes

std::string RealPath(const std::string& path) {
  char* real = IsDescriptor(path) ? nullptr : ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string target = real;
  ::free(real);
  return target;
}

bool IsWrittenInto(const std::string& path) {
  struct stat status {};
  return IsDescriptor(path) ||
         (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
          !S_ISDIR(status.st_mode));
}

std::string NeighbourOf(const std::string& target) {
  // The process number keeps two writers from sharing a name. The longest names
  // leave no room for it.
  constexpr std::size_t kMostKept = 200;
  const std::size_t slash = target.rfind('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  const std::size_t length = target.size() - begin;
  if (length > NAME_MAX) return target;  // no name, and told when it is opened
  return fmt::format("{}.{}.new",
                     target.substr(0, begin + std::min(length, kMostKept)),
                     ::getpid());
}

/// Nothing if it cannot be read.
std::optional<std::string> ContentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  if (file.bad()) return std::nullopt;
  return std::move(text).str();
}

}  // namespace

bool IsDescriptor(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/stderr" ||
         path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
}

OutputFile::OutputFile(const std::string& path) : path_(RealPath(path)) {
  if (!Open()) error_ = errno;
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!neighbour_.empty()) ::unlink(neighbour_.c_str());
}

bool OutputFile::Open() {
  if (IsWrittenInto(path_)) {
    descriptor_ =
        ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY);
    return descriptor_ >= 0;
  }
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && ::access(path_.c_str(), W_OK) != 0) return false;
  const mode_t mode = exists ? status.st_mode & 07777 : 0666;
  const std::string neighbour = NeighbourOf(path_);
  descriptor_ =
      ::open(neighbour.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor_ < 0) return false;
  neighbour_ = neighbour;
  if (exists) ::fchmod(descriptor_, mode);
  return true;
}

void OutputFile::Flush() {
  std::string_view rest = pending_;
  while (error_ == 0 && !rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count >= 0)
      rest.remove_prefix(static_cast<std::size_t>(count));
    else if (errno != EINTR)
      error_ = errno;
  }
  pending_.clear();
}

std::optional<std::string> OutputFile::Write(std::string_view text) {
  pending_ += text;
  if (pending_.size() >= kBuffer) Flush();
  return reason();
}

bool OutputFile::IsOnDisk() {
  Flush();
  if (!neighbour_.empty() && error_ == 0 && ::fsync(descriptor_) != 0)
    error_ = errno;
  return error_ == 0;
}

std::optional<std::string> OutputFile::Finish() {
  if (!IsOnDisk() || neighbour_.empty()) return reason();
  if (::rename(neighbour_.c_str(), path_.c_str()) != 0)
    error_ = errno;
  else
    neighbour_.clear();
  return reason();
}

// The two files change names in one step, so that what was there can be looked
// at after it can no longer change its place: were it another's, it goes back.
Expected<bool, std::string> OutputFile::FinishOver(
    const std::string* previous) {
  if (!IsOnDisk()) return *reason();
  if (neighbour_.empty()) return std::string("it is no regular file");
  const auto rename = [this](unsigned how) {
    return ::renameat2(AT_FDCWD, neighbour_.c_str(), AT_FDCWD, path_.c_str(),
                       how) == 0;
  };
  const unsigned how = previous == nullptr ? RENAME_NOREPLACE : RENAME_EXCHANGE;
  bool is_renamed = rename(how);
  if (!is_renamed && (errno == EINVAL || errno == ENOSYS)) {
    // A file system that cannot: what is there is looked at before.
    const auto found = ContentOf(path_);
    if (previous == nullptr ? found.has_value() : found != *previous)
      return false;
    is_renamed = rename(0);
    if (is_renamed) neighbour_.clear();
  } else if (is_renamed && previous == nullptr) {
    neighbour_.clear();
  } else if (is_renamed && ContentOf(neighbour_) != *previous) {
    // Back to how it was: what goes with the neighbour is ours.
    rename(RENAME_EXCHANGE);
    return false;
  } else if (!is_renamed && (errno == EEXIST || errno == ENOENT)) {
    return false;
  }
  if (!is_renamed) {
    error_ = errno;
    return *reason();
  }
  return true;
}

std::optional<std::string> OutputFile::reason() const {
  if (error_ == 0) return std::nullopt;
  return SystemReason(error_);
}

std::optional<std::string> WriteFile(const std::string& path,
                                     std::string_view text) {
  OutputFile file(path);
  file.Write(text);
  return file.Finish();
}

bool WriteOrReport(const std::string& path, std::string_view text, Io& io) {
  const auto failure = WriteFile(path, text);
  if (failure)
    io.err << fmt::format("error: cannot write '{}': {}\n", Escaped(path),
                          Escaped(*failure));
  return !failure;
}

}  // namespace plsc::cli
