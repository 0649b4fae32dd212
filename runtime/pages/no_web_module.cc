// Instead of what embed_module.mjs writes, where PLSC_MODULE is not set.

#include "runtime/pages/web_module.h"

namespace plsc {

std::optional<WebModule> FindWebModule() {
  return std::nullopt;
}

}  // namespace plsc
