// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace torquewright::sweep {

/// How many processes `mpirun` started, and which of them this is. One: it was not started so.
struct Ranks {
  std::size_t count = 1;
  std::size_t own = 0;
  std::string run;  ///< By which the ranks of one mpirun know each other; empty of one.
};
/// Reads them as Open MPI states them in the environment of every program that it starts.
Ranks ranks_by_environment();

/// Throws io::SpecError for a rank that is none of so many: no other would wait for it.
void require_possible(const Ranks& ranks);

}  // namespace torquewright::sweep
