#pragma once

// How often a text has a part, for tests of what is written.

#include <string>

namespace plsc::test {

inline std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos;
       at = text.find(part, at + 1))
    ++count;
  return count;
}

}  // namespace plsc::test
