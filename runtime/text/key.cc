#include "runtime/text/key.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace plsc {

Key KeyOf(std::string_view content) {
  const XXH128_hash_t hash = XXH3_128bits(content.data(), content.size());
  return {hash.high64, hash.low64};
}

std::string Hex(const Key& key) {
  return fmt::format("{:016x}{:016x}", key.high, key.low);
}

}  // namespace plsc
