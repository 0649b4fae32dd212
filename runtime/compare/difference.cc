#include "runtime/compare/difference.h"

#include <fmt/format.h>

#include <array>
#include <cstddef>

namespace plsc {

std::string_view KindName(DifferenceKind kind) {
  constexpr std::array<std::string_view, 4> kNames{"added", "missing", "moved",
                                                   "changed"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string Describe(const Difference& difference) {
  switch (difference.kind) {
    case DifferenceKind::kAdded:
    case DifferenceKind::kMissing:
      return fmt::format("{} {}", difference.what, KindName(difference.kind));
    case DifferenceKind::kMoved:
      return fmt::format("{} moved: expected {}, found {}", difference.what,
                         difference.expected, difference.found);
    case DifferenceKind::kChanged:
      return fmt::format("{}: expected {}, found {}", difference.what,
                         difference.expected, difference.found);
  }
  return "";
}

}  // namespace plsc
