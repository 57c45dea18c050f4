// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "src/sweep/ledger.hpp"

namespace torquewright::sweep {

/// How many processes `mpirun` started, and which of them this is. One: it was not started so.
struct Ranks {
  std::size_t count = 1;
  std::size_t own = 0;
};
Ranks ranks_by_environment();

/// Throws io::SpecError for a rank that is none of so many: nobody would give it work.
void require_possible(const Ranks& ranks);

/// The first rank: hands the ledger's points to the others. A rank that is silent for long is gone,
/// and its point lost. Throws io::SpecError where this program was built without MPI.
void hand_out_to_ranks(const std::string& fingerprint, Ledger& ledger);

/// Any other rank: has what it is given done by a worker, until there is no more.
void work_for_first_rank(const std::string& fingerprint);

}  // namespace torquewright::sweep
