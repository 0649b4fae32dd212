// A file without a name until it is whole: O_TMPFILE where the file system has
// it, and a neighbour with a name of its own elsewhere. It is flushed to the
// disk before it gets its name, else a power cut could leave the name with half
// of the bytes. A link, unlike a renaming, replaces nothing, so of two
// processes that make the same file one wins and the other is told; Replace
// renames over what is there, in one step.

#include "runtime/store/new_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "runtime/store/file_id.h"
#include "runtime/text/system_reason.h"

namespace plsc {

namespace {

constexpr std::size_t kBuffer = 1 << 16;  // bytes
constexpr mode_t kMode = 0666;            // less what the user masks

std::string NameOf(int descriptor) {
  return fmt::format("/proc/self/fd/{}", descriptor);
}

}  // namespace

NewFile::NewFile(std::string path, Until until) : path_(std::move(path)) {
  Open(until);
}

NewFile::~NewFile() {
  if (descriptor_ >= 0) close(descriptor_);
  if (!neighbour_.empty()) unlink(neighbour_.c_str());
}

void NewFile::Open(Until until) {
  const auto folder = std::filesystem::path(path_).parent_path();
  if (until == Until::kNameless) {
    descriptor_ = open(folder.empty() ? "." : folder.c_str(),
                       O_TMPFILE | O_RDWR | O_CLOEXEC, kMode);
    // By this name it gets its own, and not every container has it.
    if (descriptor_ >= 0 && access(NameOf(descriptor_).c_str(), F_OK) == 0)
      return;
    if (descriptor_ >= 0) close(std::exchange(descriptor_, -1));
  }
  OpenNamed();
}

std::string NewFile::Neighbour() {
  // Numbered, because a process of this number may have been killed.
  for (int i = 0;; ++i) {
    std::string name = fmt::format("{}.{}.{}.new", path_, getpid(), i);
    struct stat status {};
    if (lstat(name.c_str(), &status) != 0) return name;
  }
}

void NewFile::OpenNamed() {
  do {
    neighbour_ = Neighbour();
    descriptor_ =
        open(neighbour_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kMode);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ >= 0) return;
  error_ = errno;
  neighbour_.clear();
}

MaybeFailure NewFile::failure() const {
  if (error_ == 0) return std::nullopt;
  return fmt::format("cannot write to '{}': {}", path_, SystemReason(error_));
}

MaybeFailure NewFile::Write(std::string_view text) {
  pending_ += text;
  if (pending_.size() >= kBuffer) Flush();
  return failure();
}

void NewFile::Flush() {
  std::string_view rest = pending_;
  while (error_ == 0 && !rest.empty()) {
    const ssize_t size = write(descriptor_, rest.data(), rest.size());
    if (size >= 0)
      rest.remove_prefix(static_cast<std::size_t>(size));
    else if (errno != EINTR)
      error_ = errno;
  }
  pending_.clear();
}

/// Another name for it, which nothing may have yet. Unlike a renaming a link
/// replaces nothing.
void NewFile::Link(const std::string& name) {
  const int result = neighbour_.empty()
                         ? linkat(AT_FDCWD, NameOf(descriptor_).c_str(),
                                  AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW)
                         : link(neighbour_.c_str(), name.c_str());
  if (result == 0) return;
  error_ = errno;
  const bool knows_no_links =
      error_ == EPERM || error_ == EOPNOTSUPP || error_ == ENOSYS;
  if (!knows_no_links || neighbour_.empty()) return;
  if (renameat2(AT_FDCWD, neighbour_.c_str(), AT_FDCWD, name.c_str(),
                RENAME_NOREPLACE) != 0)
    return;
  error_ = 0;
  neighbour_.clear();
}

MaybeFailure NewFile::Publish() {
  Flush();
  if (error_ == 0 && fsync(descriptor_) != 0) error_ = errno;
  if (error_ == 0) Link(path_);
  if (error_ == 0 && !neighbour_.empty())
    unlink(std::exchange(neighbour_, "").c_str());
  return failure();
}

MaybeFailure NewFile::Replace() {
  Flush();
  if (error_ == 0 && fsync(descriptor_) != 0) error_ = errno;
  if (error_ == 0 && neighbour_.empty()) {  // only what has a name replaces
    const std::string name = Neighbour();
    Link(name);
    if (error_ == 0) neighbour_ = name;
  }
  if (error_ == 0 && std::rename(neighbour_.c_str(), path_.c_str()) != 0)
    error_ = errno;
  if (error_ == 0) neighbour_.clear();
  return failure();
}

}  // namespace plsc
