#pragma once

// What a page runs and how it looks, as bundle.mjs made it when this program
// was built; without npm (no_bundles.cc) there is none.

#include <string_view>

#include "runtime/pages/page_kind.h"

namespace plsc {

struct Bundle {
  std::string_view script;  ///< JavaScript that may stand in HTML
  std::string_view style;   ///< CSS, likewise
};

Bundle BundleOf(PageKind kind);

}  // namespace plsc
