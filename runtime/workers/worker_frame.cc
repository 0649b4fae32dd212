// A mark, a length, the text. The mark is no protocol but a check: what a
// worker's library prints to its descriptor by mistake, or the remains of a
// crash, begins otherwise, and its owner then takes it for broken instead of
// waiting for a length that is noise.

#include "runtime/workers/worker_frame.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>

namespace plsc {

namespace {

// Any eight bytes that nothing else would begin with.
constexpr std::string_view kMark = "\x01plscW\n\x02";

}  // namespace

std::string Frame(std::string_view text) {
  assert(text.size() <= kMaxFrame);
  const std::uint64_t size = text.size();
  std::string frame(kMark);
  frame.reserve(kMark.size() + sizeof size + text.size());
  frame.append(reinterpret_cast<const char*>(&size), sizeof size);
  return frame.append(text);
}

void FrameReader::Append(std::string_view bytes) {
  if (header_size_ < kHeader) {
    const std::size_t count = std::min(kHeader - header_size_, bytes.size());
    std::memcpy(header_.data() + header_size_, bytes.data(), count);
    header_size_ += count;
    bytes.remove_prefix(count);
    if (header_size_ == kHeader) ReadHeader();
  }
  if (is_broken_ || bytes.empty()) return;
  if (bytes.size() > size_ - text_.size())
    is_broken_ = true;
  else
    text_.append(bytes);
}

void FrameReader::ReadHeader() {
  static_assert(kHeader == kMark.size() + sizeof size_);
  std::memcpy(&size_, header_.data() + kMark.size(), sizeof size_);
  is_broken_ = std::string_view(header_.data(), kMark.size()) != kMark ||
               size_ > kMaxFrame;
  if (!is_broken_) text_.reserve(size_);
}

std::optional<std::string> FrameReader::Take() {
  if (is_broken_ || header_size_ < kHeader || text_.size() < size_)
    return std::nullopt;
  std::string text = std::move(text_);
  *this = {};
  return text;
}

}  // namespace plsc
