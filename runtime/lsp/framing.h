#pragma once

// Bytes of standard input to message bodies: LSP's base protocol, a header with
// Content-Length, an empty line, and so many bytes. After a header that cannot
// be read nobody knows where the next message begins, so that is the end.

#include <cstddef>
#include <string>
#include <string_view>

namespace plsc::lsp {

/// Clients send about 30 bytes.
inline constexpr std::size_t kMaxHeaderBytes = 8 * 1024;
/// A genotype has 16 MiB at most (grammar/screen.h), and each of its bytes may
/// take several in JSON.
inline constexpr std::size_t kMaxBodyBytes = std::size_t{64} << 20U;

struct Frame {
  enum class Kind {
    kIncomplete,  ///< more bytes are needed
    kBody,        ///< `text` is the body of a message
    kBroken,      ///< `text` says why nothing more can be read
  };
  Kind kind = Kind::kIncomplete;
  std::string text;
};

/// Collects bytes and hands out bodies.
class FrameReader {
 public:
  void Append(std::string_view bytes);
  /// The next whole message, if there is one. Once broken, always broken.
  Frame Next();

 private:
  Frame ReadHeader();
  Frame Break(std::string why);
  // "" when the line is fine.
  std::string ReadHeaderLine(std::string_view line);

  std::string bytes_;
  std::size_t at_ = 0;            // what is before was handed out
  std::size_t header_begin_ = 0;  // of the header that is being read
  bool has_length_ = false;
  bool is_in_body_ = false;
  std::size_t length_ = 0;
  std::string broken_;  // why; empty while all is well
};

/// The body with its header in front.
std::string FrameMessage(std::string_view body);

}  // namespace plsc::lsp
