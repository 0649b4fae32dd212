#include "runtime/store/lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace plsc {

namespace {

std::string LockOf(const std::string& run) {
  return run + ".lock";
}

std::string SystemReason(int error) {
  return std::error_code(error, std::generic_category()).message();
}

struct flock WholeFile() {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return whole;
}

std::string HostName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "unknown host";
  return name.data();
}

std::string Read(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

/// Who holds the lock on an open file, if anybody else does.
std::optional<std::string> HolderOf(int descriptor) {
  struct flock held = WholeFile();
  if (fcntl(descriptor, F_GETLK, &held) != 0 || held.l_type == F_UNLCK)
    return std::nullopt;
  // Written by the holder once it has the lock. The system knows no host.
  std::string holder = Read(descriptor);
  if (holder.empty()) holder = fmt::format("process {}", held.l_pid);
  return holder;
}

bool IsStillThere(int descriptor, const std::string& path) {
  struct stat open_file {};
  struct stat named {};
  return fstat(descriptor, &open_file) == 0 &&
         stat(path.c_str(), &named) == 0 && open_file.st_ino == named.st_ino &&
         open_file.st_dev == named.st_dev;
}

}  // namespace

RunLock::~RunLock() {
  Release();
}

std::optional<std::string> RunLock::Take(const std::string& run) {
  Release();
  path_ = LockOf(run);
  while (true) {
    descriptor_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
      return fmt::format("cannot create '{}': {}", path_, SystemReason(errno));
    struct flock whole = WholeFile();
    if (fcntl(descriptor_, F_SETLK, &whole) != 0) {
      const int error = errno;
      const auto holder = HolderOf(descriptor_);
      close(std::exchange(descriptor_, -1));
      if (error != EACCES && error != EAGAIN)
        return fmt::format("cannot lock '{}': {}", path_, SystemReason(error));
      if (!holder) continue;  // gone meanwhile
      return fmt::format(
          "'{}' is in use by {}; a run is worked on by one at a time", run,
          *holder);
    }
    // Whoever held it may have removed the file between the two calls.
    if (IsStillThere(descriptor_, path_)) break;
    close(std::exchange(descriptor_, -1));
  }
  owner_ = getpid();
  const std::string text = fmt::format("process {} on {}", owner_, HostName());
  // The lock counts, not this; on a full disk nobody is named.
  if (ftruncate(descriptor_, 0) == 0 &&
      pwrite(descriptor_, text.data(), text.size(), 0) < 0)
    return std::nullopt;
  return std::nullopt;
}

void RunLock::Release() {
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor < 0) return;
  // Locks are the process's; a child has none, and no right to the file.
  if (owner_ == getpid()) unlink(path_.c_str());
  close(descriptor);
}

std::optional<std::string> WhoWorksOn(const std::string& run) {
  const int descriptor = open(LockOf(run).c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  auto holder = HolderOf(descriptor);
  close(descriptor);
  return holder;
}

}  // namespace plsc
