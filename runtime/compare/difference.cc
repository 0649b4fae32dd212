#include "runtime/compare/difference.h"

#include <fmt/format.h>

#include "grammar/enum_names.h"

namespace plsc {

std::string_view KindName(DifferenceKind kind) {
  constexpr EnumNames<DifferenceKind, 4> kNames{
      {{DifferenceKind::kAdded, "added"},
       {DifferenceKind::kMissing, "missing"},
       {DifferenceKind::kMoved, "moved"},
       {DifferenceKind::kChanged, "changed"}}};
  return NameIn(kNames, kind);
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
