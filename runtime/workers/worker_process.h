#pragma once

// One worker, as a process: how it is forked, what it does until its owner is
// gone, and how its end is told. Which requests it gets is worker_pool's.

#include <sys/types.h>

#include <optional>
#include <string>

#include "runtime/workers/workers.h"

namespace plsc {

struct WorkerProcess {
  pid_t pid = 0;
  int socket = -1;  ///< the owner's end; frames (worker_frame.h) both ways
};

/// Forks a process that answers each request by `work`, until its owner closes
/// the socket or dies, however it does. Keeps nothing else open than its
/// socket (descriptor 3) and the standard streams: neither other workers'
/// sockets, which would hide that an owner is gone, nor a run's files with
/// their locks. Nothing where the system refuses, and errno says why.
std::optional<WorkerProcess> StartWorker(const Work& work);

/// Kills it unless it is dead already, and tells how it ended: "signal 11",
/// "exit status 2". Exit status 2 is an exception.
std::string EndWorker(const WorkerProcess& worker);

}  // namespace plsc
