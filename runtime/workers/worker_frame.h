#pragma once

// How texts are put on the socket between a run and one of its workers: a mark,
// the number of bytes in 8 bytes, then the bytes. Both ends are the same
// program on the same machine, so its byte order is right. One text is under
// way at a time: the next request comes after the answer.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plsc {

/// Longest text of a frame. Robots have kilobytes; a length beyond this was
/// never sent by us.
inline constexpr std::uint64_t kMaxFrame = std::uint64_t{1} << 30;

std::string Frame(std::string_view text);

/// Puts together what arrives in pieces.
class FrameReader {
 public:
  void Append(std::string_view bytes);
  /// The text of the frame when all of it is there; then starts anew.
  std::optional<std::string> Take();
  /// What came is no frame, or more than one; there is no way on.
  bool is_broken() const { return is_broken_; }

 private:
  static constexpr std::size_t kHeader = 16;
  void ReadHeader();

  std::array<char, kHeader> header_ = {};
  std::size_t header_size_ = 0;
  std::uint64_t size_ = 0;  // of the text, once the header is there
  std::string text_;
  bool is_broken_ = false;
};

}  // namespace plsc
