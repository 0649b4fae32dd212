#include "runtime/lsp/server.h"

#include <algorithm>
#include <istream>
#include <ostream>
#include <streambuf>
#include <string>

#include "runtime/cli/arguments/editors.h"
#include "runtime/lsp/framing.h"
#include "runtime/text/version.h"

namespace plsc::cli {

namespace {

// A client that types without a pause still gets diagnostics: after so many
// messages even if more are waiting.
constexpr int kMaxMessagesBeforeIdle = 64;

void Send(const std::vector<std::string>& bodies, Io& io) {
  for (const std::string& body : bodies) io.out << lsp::FrameMessage(body);
  if (!bodies.empty()) io.out.flush();
}

// Whether bytes can be read without waiting.
bool IsWaiting(Io& io) {
  return io.in.rdbuf()->in_avail() > 0;
}

// What has come, at least one byte; waits for it. Empty at the end.
std::string ReadSome(Io& io) {
  using Traits = std::streambuf::traits_type;
  std::streambuf& buffer = *io.in.rdbuf();
  if (Traits::eq_int_type(buffer.sgetc(), Traits::eof())) return "";
  // Pipes hold 64 KiB.
  constexpr std::streamsize kMostBytes = std::streamsize{64} << 10U;
  std::string bytes(static_cast<std::size_t>(std::clamp<std::streamsize>(
                        buffer.in_avail(), 1, kMostBytes)),
                    '\0');
  const std::streamsize count =
      buffer.sgetn(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(count, 0)));
  return bytes;
}

}  // namespace

Exit Run(const LspCommand&, Io& io) {
  lsp::Server server(kVersion);
  lsp::FrameReader frames;
  int messages = 0;  // since the last piece of idle work
  while (!server.exit_status()) {
    const lsp::Frame frame = frames.Next();
    if (frame.kind == lsp::Frame::Kind::kBroken) {
      Send({lsp::BrokenBody(frame.text)}, io);
      return Exit::kBadInput;
    }
    if (frame.kind == lsp::Frame::Kind::kBody) {
      Send(server.Handle(frame.text), io);
      ++messages;
    }
    const bool has_more =
        frame.kind == lsp::Frame::Kind::kBody || IsWaiting(io);
    if (server.has_work() && (!has_more || messages > kMaxMessagesBeforeIdle)) {
      Send(server.Idle(), io);
      messages = 0;
    } else if (frame.kind == lsp::Frame::Kind::kIncomplete) {
      const std::string bytes = ReadSome(io);
      if (bytes.empty()) return Exit::kBadInput;
      frames.Append(bytes);
    }
  }
  return *server.exit_status() == 0 ? Exit::kFine : Exit::kBadInput;
}

}  // namespace plsc::cli
