#include "compiler/expectation.h"

#include <array>

namespace plsc {

std::string_view FaceName(Face face) {
  constexpr std::array<std::string_view, kFaces> kNames = {"back", "front",
                                                           "left", "right"};
  return kNames[static_cast<std::size_t>(face)];
}

}  // namespace plsc
