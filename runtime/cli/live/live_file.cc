#include "runtime/cli/live/live_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <utility>

#include "runtime/cli/files/output_file.h"
#include "runtime/text/key.h"
#include "runtime/text/system_reason.h"

namespace plsc::cli {

namespace {

// Clocks of file systems have ticks of up to 10 ms (ext4: 4), those of network
// folders and of FAT up to 2 s: what was written twice within one looks as if
// it was written once, so a young file is read again.
constexpr std::int64_t kYoung = 2'100'000'000;  // ns

std::int64_t Nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::int64_t Now() {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return Nanoseconds(now);
}

FileState Unreadable(std::string reason) {
  return {std::nullopt, std::move(reason), ""};
}

}  // namespace

LiveFile::LiveFile(std::string path) : path_(std::move(path)) {
  mark_ = ReadMark();
  state_ = Read();
}

LiveFile::Mark LiveFile::ReadMark() const {
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0) return {};
  return {true,
          status.st_dev,
          status.st_ino,
          status.st_size,
          Nanoseconds(status.st_mtim),
          Nanoseconds(status.st_ctim)};
}

FileState LiveFile::Read() const {
  // A pipe in its place would have us wait for ever.
  const int file = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return Unreadable(SystemReason(errno));
  struct stat status {};
  FileState state;
  if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) {
    state = Unreadable("it is no regular file");
  } else {
    std::string text;
    std::array<char, 1 << 16> buffer;
    ssize_t count = 0;
    while (text.size() <= kMostBytes) {
      count = ::read(file, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) break;
      text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    if (count < 0)
      state = Unreadable(SystemReason(errno));
    else if (text.size() > kMostBytes)
      state =
          Unreadable(fmt::format("it has more than {} MiB", kMostBytes >> 20U));
    else
      state = {text, "", Hex(KeyOf(text))};
  }
  ::close(file);
  return state;
}

bool LiveFile::Look() {
  const Mark mark = ReadMark();
  const bool is_young = mark.is_there && Now() - mark.modified < kYoung;
  if (mark == mark_ && !is_young) return false;
  mark_ = mark;
  FileState now = Read();
  if (now == state_) return false;
  state_ = std::move(now);
  return true;
}

LiveFile::Saved LiveFile::Save(const std::string& text,
                               const std::string& base) {
  Look();
  if (state_.version != base || (base.empty() && mark_.is_there))
    return {true, std::nullopt};
  OutputFile file(path_);
  file.Write(text);
  const auto taken = file.FinishOver(base.empty() ? nullptr : &*state_.text);
  Look();
  if (!taken) return {false, Failure(taken.error())};
  return {!*taken, std::nullopt};
}

}  // namespace plsc::cli
