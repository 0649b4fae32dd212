#include "runtime/workers/mpi_link.h"

namespace plsc {

std::unique_ptr<RankLink> ConnectRanks() {
  return nullptr;
}

}  // namespace plsc
