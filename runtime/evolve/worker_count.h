#pragma once

// How many workers a run gets where nobody said a number: as many as the cores
// that this process may use, which in containers and batch jobs are fewer than
// the machine has.

#include <string>

namespace plsc {

/// Cores that this process may use, at least 1: the fewest of
/// - those that it is bound to (taskset, Slurm with cpusets, mpirun);
/// - the CPU time that its control groups get, of both versions, a started core
///   counted whole (docker --cpus, systemd's CPUQuota, Kubernetes).
/// `root` is put before /proc and /sys; only tests have another.
int UsableCores(const std::string& root = "");

/// `jobs`, or UsableCores if that is 0.
int WorkerCount(int jobs);

}  // namespace plsc
