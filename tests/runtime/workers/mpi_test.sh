#!/bin/sh
# mpi_test.sh PROGRAM RANKS [TEST]: runs mpi_test_program under mpirun, more
# ranks than cores if need be. 77 (skipped) where there is no mpirun.
set -u
if ! command -v mpirun >/dev/null 2>&1; then
  echo "skipped: there is no mpirun (Debian: openmpi-bin)"
  exit 77
fi
# Containers are root; the workers of a rank are not to share its one core.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
timeout -k 5 100 mpirun --oversubscribe --bind-to none -n "$2" "$1" "${3-all}"
