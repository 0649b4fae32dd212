#include "runtime/pages/bundles.h"

namespace plsc {

bool HasPages() {
  return false;
}

Bundle BundleOf(PageKind /*kind*/) {
  return {};
}

}  // namespace plsc
