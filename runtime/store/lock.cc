// A lock must not outlive its owner: it is the system's, on the open file, and
// is gone however its owner ends. It is an open file description lock, since
// the usual POSIX lock is dropped as soon as any part of the process closes the
// file, which SQLite does. It lies on bytes that SQLite does not use, as many
// as the number of the process, and so tells who holds it.
//
// The file may be replaced between opening and locking it, so afterwards its
// name is asked again, and the whole is repeated where it means another file.
// Within a process such a lock stops nobody, so what is held here is kept in a
// table.

#include "runtime/store/lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <map>
#include <utility>

#include "runtime/store/database.h"
#include "runtime/text/system_reason.h"

namespace plsc {

namespace {

// Behind those that SQLite locks, 510 from 0x40000000 on. As many as the number
// of the process, so that whoever asks for the lock learns who has it: the
// system does not tell of such locks.
constexpr off_t kFirstByte = 0x50000000;

struct flock BytesFor(pid_t process) {
  struct flock bytes {};
  bytes.l_type = F_WRLCK;
  bytes.l_whence = SEEK_SET;
  bytes.l_start = kFirstByte;
  bytes.l_len = process;
  return bytes;
}

/// What this process has locked, and the process, which a fork changes.
std::map<FileId, pid_t>& Held() {
  static std::map<FileId, pid_t> held;
  return held;
}

bool IsHeldHere(const std::optional<FileId>& file) {
  if (!file) return false;
  const auto held = Held().find(*file);
  return held != Held().end() && held->second == getpid();
}

/// Which process holds the lock on an open file, if any does.
std::optional<pid_t> HolderOf(int descriptor) {
  struct flock held = BytesFor(1);
  if (fcntl(descriptor, F_OFD_GETLK, &held) != 0 || held.l_type == F_UNLCK)
    return std::nullopt;
  return static_cast<pid_t>(held.l_len);
}

/// The host is in the store, once the process has begun its session there.
std::string NameOf(pid_t process, const std::string& run) {
  std::string name = fmt::format("process {}", process);
  Database database;
  if (database.Open(run, Database::Mode::kRead)) return name;
  Statement session(database,
                    "SELECT host FROM session WHERE pid = ? AND ended IS NULL "
                    "ORDER BY id DESC LIMIT 1");
  if (session.With(process).Next()) name += " on " + session.TakeText();
  return name;
}

std::string InUse(const std::string& run, pid_t process) {
  return fmt::format(
      "'{}' is in use by {}; a run is worked on by one at a time", run,
      NameOf(process, run));
}

}  // namespace

RunLock::~RunLock() {
  Release();
}

MaybeFailure RunLock::Take(const std::string& run) {
  Release();
  if (IsHeldHere(FileIdOf(run))) return InUse(run, getpid());
  while (true) {
    descriptor_ = open(run.c_str(), O_RDWR | O_CLOEXEC);
    if (descriptor_ < 0)
      return fmt::format("cannot open '{}': {}", run, SystemReason(errno));
    if (MaybeFailure failure = Lock(run)) return failure;
    // It may have been replaced between the two calls.
    if (FileIdOf(run) == file_) return std::nullopt;
    Release();
  }
}

MaybeFailure RunLock::TakeNew(const std::string& run, int descriptor) {
  Release();
  // Another descriptor of the same open file, whose the lock is.
  descriptor_ = fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  if (descriptor_ < 0)
    return fmt::format("cannot lock '{}': {}", run, SystemReason(errno));
  return Lock(run);
}

MaybeFailure RunLock::Lock(const std::string& run) {
  struct flock bytes = BytesFor(getpid());
  while (fcntl(descriptor_, F_OFD_SETLK, &bytes) != 0) {
    const int error = errno;
    const std::optional<pid_t> holder = HolderOf(descriptor_);
    const bool is_held = error == EACCES || error == EAGAIN;
    if (is_held && !holder) continue;  // gone meanwhile
    close(std::exchange(descriptor_, -1));
    if (is_held) return InUse(run, *holder);
    return fmt::format("cannot lock '{}': {}", run, SystemReason(error));
  }
  struct stat status {};
  fstat(descriptor_, &status);
  file_ = IdOf(status);
  Held()[file_] = getpid();
  return std::nullopt;
}

void RunLock::Release() {
  // In a child of a fork this drops nothing: the lock is the open file's, which
  // the parent has, too.
  const int descriptor = std::exchange(descriptor_, -1);
  if (descriptor < 0) return;
  Held().erase(file_);
  close(descriptor);
}

std::optional<std::string> WhoWorksOn(const std::string& run) {
  if (IsHeldHere(FileIdOf(run))) return NameOf(getpid(), run);
  const int descriptor = open(run.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  const auto holder = HolderOf(descriptor);
  close(descriptor);
  if (!holder) return std::nullopt;
  return NameOf(*holder, run);
}

}  // namespace plsc
