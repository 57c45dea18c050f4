// SPDX-License-Identifier: Apache-2.0
// In place of ranks_mpi.cpp where OpenMPI is not installed.
#include "io/faults/refusal.hpp"
#include "src/sweep/ranks.hpp"

namespace torquewright::sweep {
namespace {

[[noreturn]] void refuse() {
  io::refuse("mpirun",
             "this program was built without MPI: install libopenmpi-dev and openmpi-bin (Debian's "
             "names) and build it again; without mpirun --jobs uses this machine's processors");
}

}  // namespace

void hand_out_to_ranks(const std::string&, Ledger&) { refuse(); }

void work_for_first_rank(const std::string&) { refuse(); }

}  // namespace torquewright::sweep
