#include "runtime/workers/mpi_session.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace plsc {

// What it does under mpirun: mpi_test_program.cc.

TEST_CASE("Only a launcher of several processes is MPI", "[mpi]") {
  using Variables = std::map<const char*, const char*>;
  struct Row {
    const char* why;
    Variables variables;
    bool expected;
  };
  const std::vector<Row> rows = {
      {"started by hand", {}, false},
      {"mpirun -n 2",
       {{"OMPI_COMM_WORLD_SIZE", "2"}, {"PMIX_RANK", "1"}},
       true},
      {"mpirun -n 1",
       {{"OMPI_COMM_WORLD_SIZE", "1"}, {"PMIX_RANK", "0"}},
       false},
      {"MPICH's mpirun, or srun --mpi=pmi2", {{"PMI_SIZE", "4"}}, true},
      {"srun --mpi=pmix", {{"PMIX_RANK", "0"}}, true}};
  for (const Row& row : rows) {
    DYNAMIC_SECTION(row.why) {
      for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
        unsetenv(name);
      for (const auto& [name, value] : row.variables) setenv(name, value, 1);
      CHECK(MpiSession::IsUnderMpi() == row.expected);
      for (const auto& [name, value] : row.variables) unsetenv(name);
    }
  }
}

TEST_CASE("Who has not joined is a rank alone", "[mpi]") {
  const MpiSession session;
  CHECK(session.rank() == 0);
  CHECK(session.size() == 1);
}

}  // namespace plsc
