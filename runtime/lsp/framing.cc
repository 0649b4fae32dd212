// Headers and bodies from bytes that come in any portions. What was handed out
// is dropped only when it is most of the memory, else a flood of small messages
// would move the rest once a message. After a header that cannot be read the
// next beginning is unknown, so the stream is broken for good.

#include "runtime/lsp/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "grammar/number.h"

namespace plsc::lsp {

namespace {

bool EqualsIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

std::string_view Trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

// `Content-Length`: what JSON without a header never is.
bool IsFieldName(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return c == '-' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  });
}

}  // namespace

void FrameReader::Append(std::string_view bytes) {
  // What was handed out is dropped once it is most of the memory: moving the
  // rest for each small message would cost the square of a flood's size.
  if (at_ > bytes_.size() / 2) {
    bytes_.erase(0, at_);
    header_begin_ -= std::min(header_begin_, at_);
    at_ = 0;
  }
  if (broken_.empty()) bytes_ += bytes;
}

Frame FrameReader::Break(std::string why) {
  broken_ = std::move(why);
  bytes_.clear();
  at_ = 0;
  return {Frame::Kind::kBroken, broken_};
}

Frame FrameReader::Next() {
  if (!broken_.empty()) return {Frame::Kind::kBroken, broken_};
  if (!is_in_body_) {
    Frame header = ReadHeader();
    if (!is_in_body_) return header;
  }
  if (bytes_.size() - at_ < length_) return {};
  Frame frame{Frame::Kind::kBody, bytes_.substr(at_, length_)};
  at_ += length_;
  header_begin_ = at_;
  is_in_body_ = false;
  has_length_ = false;
  return frame;
}

// Line by line, so that text without any header is told at its first line.
Frame FrameReader::ReadHeader() {
  while (true) {
    const std::size_t end = bytes_.find('\n', at_);
    const std::size_t header_end = std::min(end, bytes_.size());
    if (header_end - header_begin_ > kMaxHeaderBytes)
      return Break(fmt::format("expected a header of at most {} bytes",
                               kMaxHeaderBytes));
    if (end == std::string::npos) return {};
    std::string_view line = std::string_view(bytes_).substr(at_, end - at_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty()) {
      if (!has_length_) return Break("expected 'Content-Length: N'");
      at_ = end + 1;
      is_in_body_ = true;
      return {};
    }
    std::string problem = ReadHeaderLine(line);
    if (!problem.empty()) return Break(std::move(problem));
    at_ = end + 1;
  }
}

std::string FrameReader::ReadHeaderLine(std::string_view line) {
  const std::size_t colon = line.find(':');
  const std::string_view name = Trimmed(line.substr(0, colon));
  if (colon == std::string_view::npos || !IsFieldName(name))
    return "expected a header line 'Content-Length: N'";
  // Content-Type says what is always so (UTF-8); others are for others.
  if (!EqualsIgnoringCase(name, "Content-Length")) return "";
  const std::string_view value = Trimmed(line.substr(colon + 1));
  const auto length = ParseNumber<std::size_t>(value);
  if (!length || *length > kMaxBodyBytes)
    return fmt::format("expected a Content-Length of 0 to {}", kMaxBodyBytes);
  length_ = *length;
  has_length_ = true;
  return "";
}

std::string FrameMessage(std::string_view body) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body);
}

}  // namespace plsc::lsp
