#pragma once

// How many workers a run gets where nobody said a number: as many as the cores
// that this process may use, which in containers and batch jobs are fewer than
// the machine has, and which the ranks of an MPI job on one machine may have to
// share.

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

/// The cores of one of several ranks on this machine, at least 1: `own` are
/// those that it may use, `together` those that all of them may. Ranks bound to
/// cores of their own have these; those that overlap share.
int ShareOfRank(int own, int together, int ranks, int rank);

/// `jobs`, or this rank's share if that is 0. What there is to share is what
/// the launcher, our parent, may use; how many share it is in the environment
/// (Open MPI, MPICH, Intel MPI), or else each rank is taken to be alone.
int RankWorkerCount(int jobs);

}  // namespace plsc
