// Workers that are forked before the run is known get it with each request, as
// text in front of it. Comparing it with the last one is all that it costs
// where the run stays the same; so no rank has to be told in the right order,
// and a worker that replaces a dead one needs nothing special.

#include "runtime/workers/worker_setup.h"

#include <cassert>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

namespace plsc {

namespace {

struct Made {
  std::string setup;
  Work work;
};

}  // namespace

// The setup's number of bytes in 8 bytes, the setup, the request.
std::string RequestWithSetup(const std::string& setup,
                             const std::string& request) {
  const std::uint64_t size = setup.size();
  std::string text(reinterpret_cast<const char*>(&size), sizeof size);
  text.reserve(sizeof size + setup.size() + request.size());
  return text.append(setup).append(request);
}

Work WorkWithSetup(MakeWork make_work) {
  // Each worker is a process, so each has its own.
  auto made = std::make_shared<std::optional<Made>>();
  return [made, make_work = std::move(make_work)](const std::string& text) {
    std::uint64_t size = 0;
    assert(text.size() >= sizeof size);
    std::memcpy(&size, text.data(), sizeof size);
    const std::string_view rest = std::string_view(text).substr(sizeof size);
    assert(rest.size() >= size);
    const std::string_view setup = rest.substr(0, size);
    if (!*made || (*made)->setup != setup) {
      std::string copy(setup);
      Work work = make_work(copy);
      *made = Made{std::move(copy), std::move(work)};
    }
    return (*made)->work(std::string(rest.substr(size)));
  };
}

}  // namespace plsc
