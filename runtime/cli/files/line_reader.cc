#include "runtime/cli/files/line_reader.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <istream>
#include <utility>

namespace plsc::cli {

void LineReader::Fill(int timeout_ms) {
  if (is_closed_) return;
  std::array<char, 1 << 16> buffer{};
  if (io_.input_descriptor < 0) {
    // A stream of a test: it has all that it will ever have.
    io_.in.read(buffer.data(), buffer.size());
    Take(buffer.data(), static_cast<std::size_t>(io_.in.gcount()));
    is_closed_ = !io_.in;
  } else {
    pollfd input{io_.input_descriptor, POLLIN, 0};
    if (poll(&input, 1, timeout_ms) <= 0) return;
    const ssize_t count = read(input.fd, buffer.data(), buffer.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (count > 0) Take(buffer.data(), static_cast<std::size_t>(count));
    is_closed_ = count <= 0;
  }
  if (is_closed_ && (!begun_.text.empty() || begun_.is_cut)) EndLine();
}

void LineReader::Take(const char* bytes, std::size_t count) {
  const char* const end = bytes + count;
  while (bytes != end) {
    const char* const stop = std::find(bytes, end, '\n');
    const auto length = static_cast<std::size_t>(stop - bytes);
    const std::size_t room = longest_ - begun_.text.size();
    begun_.text.append(bytes, std::min(length, room));
    begun_.is_cut = begun_.is_cut || length > room;
    if (stop == end) return;
    EndLine();
    bytes = stop + 1;
  }
}

void LineReader::EndLine() {
  const std::size_t next = begun_.number + 1;
  lines_.push_back(std::exchange(begun_, {next, "", false}));
}

std::optional<InputLine> LineReader::Next() {
  if (lines_.empty()) return std::nullopt;
  InputLine line = std::move(lines_.front());
  lines_.pop_front();
  return line;
}

}  // namespace plsc::cli
