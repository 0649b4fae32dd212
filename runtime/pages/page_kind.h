#pragma once

#include <cstdint>

namespace plsc {

enum class PageKind : std::uint8_t { kReport, kView, kExplain, kLive };

}  // namespace plsc
