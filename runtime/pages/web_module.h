#pragma once

// plsc itself for a page, as WebAssembly (runtime/web), and the script that
// opens it. A build has it if PLSC_MODULE named the folder of one; otherwise
// (no_web_module.cc) pages that run robots need `plsc live` to answer them.

#include <optional>
#include <string_view>

namespace plsc {

struct WebModule {
  std::string_view packed;  ///< base64 of gzip of plsc.wasm
  std::string_view glue;    ///< plsc.js
};

std::optional<WebModule> FindWebModule();

}  // namespace plsc
