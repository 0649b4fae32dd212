#pragma once

// What a PNG says of itself, read from its first chunk (IHDR).

#include <optional>
#include <string>

namespace plsc::test {

struct PngSize {
  unsigned width = 0;
  unsigned height = 0;
};

inline std::optional<PngSize> PngSizeOf(const std::string& png) {
  if (png.size() < 24 || png.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 ||
      png.compare(12, 4, "IHDR") != 0)
    return std::nullopt;
  const auto number = [&png](std::size_t at) {
    unsigned value = 0;  // most significant byte first
    for (std::size_t i = at; i < at + 4; ++i)
      value = value * 256 + static_cast<unsigned char>(png[i]);
    return value;
  };
  return PngSize{number(16), number(20)};
}

}  // namespace plsc::test
