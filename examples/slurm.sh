#!/usr/bin/env bash
# A study on a cluster that Slurm manages: a job array of which each task does
# a shard of the runs. Submit it from a folder that all nodes see:
#
#   sbatch examples/slurm.sh examples/paper_study.yaml results
#   sbatch --array=1-40 --cpus-per-task=2 examples/slurm.sh STUDY FOLDER
#
# Before the time limit, and when a job of higher priority takes its place, a
# task stops cleanly, is queued again, and goes on where it was. Tasks may also
# be killed, or the whole array be submitted again: what is done is not done
# twice, and what another task works on is left alone.
#
#SBATCH --job-name=plsc-study
#SBATCH --array=1-8
#SBATCH --cpus-per-task=4
#SBATCH --mem-per-cpu=1G
#SBATCH --time=24:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=study-%A-%a.log
# To the script, two minutes before the time limit. Stopping takes seconds: the
# simulations under way are ended first.
#SBATCH --signal=B:USR1@120
set -u

if [ $# -ne 2 ]; then
  echo "usage: sbatch [--array=1-N] slurm.sh STUDY FOLDER" >&2
  exit 2
fi
study=$1
folder=$2
# The array is 1-N. To submit some of its tasks again, say of how many:
#   SHARDS=40 sbatch --array=3,17 examples/slurm.sh STUDY FOLDER
shards=${SHARDS:-$SLURM_ARRAY_TASK_MAX}

out_of_time=no
plsc study run "$study" -o "$folder" --shard "$SLURM_ARRAY_TASK_ID/$shards" \
  --jobs "$SLURM_CPUS_PER_TASK" &
runner=$!
# Preempted: Slurm itself queues it again.
trap 'is_signalled=yes; kill -TERM "$runner"' TERM
trap 'is_signalled=yes; out_of_time=yes; kill -TERM "$runner"' USR1
while true; do
  is_signalled=no
  wait "$runner"
  status=$?
  [ "$is_signalled" = no ] && break # else only the waiting has ended
done
if [ "$out_of_time" = yes ] && [ "$status" -eq 130 ]; then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$status"
