#include "runtime/cli/files/io.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <istream>
#include <ostream>
#include <utility>

#include "grammar/shown_line.h"
#include "runtime/text/system_reason.h"

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
          fmt::format("cannot read '{}': {}", path, SystemReason(error))};
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

std::optional<Source> ReadOrReport(const std::string& path, Io& io) {
  Result<Source> source = ReadSource(path, io);
  if (source) return std::move(*source);
  ReportUnreadable(source.diagnostics()[0], io);
  return std::nullopt;
}

std::string RenderWithoutLine(const Diagnostic& problem) {
  return fmt::format("error[{}]: {}\n", NumberOf(problem.code),
                     Escaped(problem.message));
}

void ReportUnreadable(const Diagnostic& problem, Io& io) {
  io.err << RenderWithoutLine(problem);
}

void Report(const std::vector<Diagnostic>& diagnostics, const Source& source,
            Io& io) {
  RenderOptions options;
  options.in_color = io.err_in_color;
  io.err << Render(diagnostics, source, options);
}

}  // namespace plsc::cli
