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
#include <cstdlib>
#include <ostream>
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

std::optional<std::string> OutputFile::Finish() {
  Flush();
  if (neighbour_.empty()) return reason();
  if (error_ == 0 && ::fsync(descriptor_) != 0) error_ = errno;
  if (error_ == 0 && ::rename(neighbour_.c_str(), path_.c_str()) != 0)
    error_ = errno;
  if (error_ == 0) neighbour_.clear();
  return reason();
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
