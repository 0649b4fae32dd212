#include "runtime/cli/files/io.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <istream>
#include <iterator>
#include <ostream>

#include "grammar/shown_line.h"
#include "runtime/cli/files/pipe_errors.h"

namespace plsc::cli {

namespace {

constexpr std::size_t kMaxFileBytes = 16u << 20;

// Closes what open() returned.
class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

Diagnostic CannotRead(const std::string& path, int error) {
  return {Code::kUnreadableFile,
          {},
          fmt::format("cannot read '{}': {}", path, std::strerror(error))};
}

Diagnostic TooLarge(const std::string& path) {
  return {
      Code::kTooLargeFile, {}, fmt::format("'{}' is larger than 16 MiB", path)};
}

Result<Source> ReadStandardInput(Io& io) {
  std::string text;
  char buffer[4096];
  while (io.in.read(buffer, sizeof buffer) || io.in.gcount() > 0) {
    text.append(buffer, static_cast<std::size_t>(io.in.gcount()));
    if (text.size() > kMaxFileBytes) return TooLarge("<stdin>");
  }
  return Source("<stdin>", std::move(text));
}

// Read, not mapped: a file truncated meanwhile must not raise SIGBUS.
Result<Source> ReadWhole(const std::string& path, int descriptor) {
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return CannotRead(path, errno);
    if (count == 0) break;
    text.append(buffer, static_cast<std::size_t>(count));
    if (text.size() > kMaxFileBytes) return TooLarge(path);
  }
  return Source(path, std::move(text));
}

bool WriteAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

std::optional<std::string> WriteInto(const std::string& path,
                                     std::string_view text) {
  const PipeErrors are_errors;
  const File file(
      ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | O_NOCTTY));
  if (file.get() < 0 || !WriteAll(file.get(), text))
    return std::strerror(errno);
  return std::nullopt;
}

}  // namespace

bool WantsColor(bool is_terminal, const char* no_color) {
  return is_terminal && (no_color == nullptr || *no_color == '\0');
}

Result<Source> ReadSource(const std::string& path, Io& io) {
  if (path == "-") return ReadStandardInput(io);
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) return CannotRead(path, errno);
  struct stat status {};
  if (::fstat(file.get(), &status) == 0 && S_ISDIR(status.st_mode))
    return CannotRead(path, EISDIR);
  return ReadWhole(path, file.get());
}

bool IsDescriptor(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/stderr" ||
         path.starts_with("/dev/fd/") || path.starts_with("/proc/self/fd/");
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

std::string RealPath(const std::string& path) {
  char* real = IsDescriptor(path) ? nullptr : ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  std::string target = real;
  ::free(real);
  return target;
}

std::optional<std::string> WriteFile(const std::string& path,
                                     std::string_view text) {
  if (IsWrittenInto(path)) return WriteInto(path, text);
  const std::string target = RealPath(path);
  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && ::access(target.c_str(), W_OK) != 0)
    return std::strerror(errno);
  const mode_t mode = exists ? status.st_mode & 07777 : 0666;
  const std::string neighbour = NeighbourOf(target);
  int error = 0;
  {
    const File file(::open(neighbour.c_str(),
                           O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (file.get() < 0) return std::strerror(errno);
    if (exists) ::fchmod(file.get(), mode);
    if (!WriteAll(file.get(), text) || ::fsync(file.get()) != 0) error = errno;
  }
  if (error == 0 && ::rename(neighbour.c_str(), target.c_str()) == 0)
    return std::nullopt;
  if (error == 0) error = errno;
  ::unlink(neighbour.c_str());
  return std::strerror(error);
}

std::string HeadlineOf(const Diagnostic& diagnostic) {
  return fmt::format("error[{}]: {}\n", NumberOf(diagnostic.code),
                     Escaped(diagnostic.message));
}

std::optional<Source> LoadSource(const std::string& path, Io& io) {
  Result<Source> source = ReadSource(path, io);
  if (source) return std::move(*source);
  io.err << HeadlineOf(source.diagnostics()[0]);
  return std::nullopt;
}

void Report(const std::vector<Diagnostic>& diagnostics, const Source& source,
            Io& io) {
  RenderOptions options;
  options.in_color = io.err_in_color;
  io.err << Render(diagnostics, source, options);
}

}  // namespace plsc::cli
