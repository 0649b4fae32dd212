#include "runtime/workers/mpi_message.h"

#include <cassert>
#include <cstring>

namespace plsc {

std::string Encode(const RankWords& words) {
  std::string message(1, static_cast<char>(words.word));
  const std::int32_t number = words.number;
  message.append(reinterpret_cast<const char*>(&number), sizeof number);
  return message += words.text;
}

RankWords Decode(const std::string& message) {
  std::int32_t number = 0;
  constexpr std::size_t kHeader = 1 + sizeof number;
  assert(message.size() >= kHeader);
  std::memcpy(&number, message.data() + 1, sizeof number);
  return {static_cast<RankWord>(message[0]), number, message.substr(kHeader)};
}

std::string ProgramVersion() {
  return "plsc " PLSC_VERSION ", ODE " PLSC_ODE_VERSION ", g++ " __VERSION__;
}

}  // namespace plsc
