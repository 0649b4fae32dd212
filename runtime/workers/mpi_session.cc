#include "runtime/workers/mpi_session.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <cassert>
#include <cstdlib>
#include <utility>

#include "runtime/workers/mpi_link.h"
#include "runtime/workers/mpi_message.h"
#include "runtime/workers/mpi_pause.h"
#include "runtime/workers/mpi_server.h"
#include "runtime/workers/mpi_workers.h"
#include "runtime/workers/worker_count.h"
#include "runtime/workers/worker_pool.h"

namespace plsc {

namespace {

/// How many processes the launcher says that there are: Open MPI's mpirun, and
/// those that speak PMI (MPICH's, Intel's, Slurm's srun). Nothing if no one
/// says so.
std::optional<int> LaunchedRanks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* value = std::getenv(name)) return std::atoi(value);
  return std::nullopt;
}

/// mpirun sends on SIGUSR1, and kills what it gives SIGTERM a second later:
/// so the one is the way to ask for the other.
void SetSignalsOfRank(int rank) {
  if (rank == 0) {
    signal(SIGUSR1, [](int) { kill(getpid(), SIGTERM); });
  } else {
    for (const int stop : {SIGINT, SIGTERM, SIGUSR1}) signal(stop, SIG_IGN);
  }
}

}  // namespace

struct MpiSession::State {
  std::unique_ptr<WorkerPool> pool;
  std::unique_ptr<RankLink> link;
};

bool MpiSession::IsUnderMpi() {
  if (const std::optional<int> ranks = LaunchedRanks()) return *ranks > 1;
  // srun --mpi=pmix tells a process its rank alone.
  return std::getenv("PMIX_RANK") != nullptr;
}

MpiSession::MpiSession() : state_(std::make_unique<State>()) {}

std::optional<std::string> MpiSession::Join(int workers, MakeWork make_work) {
  assert(!state_->link);
  state_->pool = std::make_unique<WorkerPool>(
      WorkerPoolOptions{RankWorkerCount(workers), 0},
      WorkWithSetup(std::move(make_work)));
  state_->link = ConnectRanks();
  if (!state_->link)
    return "started by mpirun with more than one rank, but built without MPI; "
           "build plsc where cmake finds MPI (libopenmpi-dev), or start it "
           "without mpirun";
  SetSignalsOfRank(rank());
  // A launcher of another MPI starts N ranks that do not know of each other.
  const std::optional<int> launched = LaunchedRanks();
  if (launched && *launched != size())
    return fmt::format(
        "started as one of {} ranks, but MPI sees {}; use the mpirun of the "
        "MPI that plsc was built with",
        *launched, size());
  return std::nullopt;
}

MpiSession::~MpiSession() {
  if (!state_->link || rank() != 0) return;
  int others = size() - 1;
  for (int other = 1; other <= others; ++other)
    state_->link->Send(other, Encode({RankWord::kEnd, 0, ""}));
  // Answers that nobody wants any more come first; unless all has been
  // received MPI cannot end.
  MpiPause pause;
  while (others > 0) {
    const auto message = state_->link->Receive();
    if (message && Decode(message->text).word == RankWord::kBye)
      --others;
    else if (!message)
      poll(nullptr, 0, pause.Next(false));
  }
}

int MpiSession::rank() const {
  return state_->link ? state_->link->rank() : 0;
}

int MpiSession::size() const {
  return state_->link ? state_->link->size() : 1;
}

std::unique_ptr<Workers> MpiSession::MakeWorkers(std::string setup,
                                                 double hang_seconds) {
  assert(state_->link && rank() == 0);
  return std::make_unique<MpiWorkers>(*state_->link, *state_->pool,
                                      std::move(setup), hang_seconds);
}

void MpiSession::Serve() {
  assert(state_->link && rank() != 0);
  RankServer(*state_->link, *state_->pool).Serve();
}

}  // namespace plsc
