// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "identification/gram.hpp"
#include "identification/log.hpp"

namespace torquewright::identification {

/// Which blocks are left out together: each training run is a fold; with fewer than three of them,
/// runs are cut into contiguous pieces, three at least in all. Held-out runs have no fold.
struct Folds {
  std::vector<std::size_t> of_run;  ///< By Log::runs; Fitter::kNoFold: held out.
  std::vector<std::size_t> of_block;
  bool cut_runs = false;
};
Folds make_folds(const Log& log, const Gram& gram);
/// The same for folds of runs that are known.
Folds folds_of_blocks(std::vector<std::size_t> of_run, const Gram& gram);

/// The same by run alone, for before there is a Gram.
std::vector<std::size_t> run_folds(const Log& log);

}  // namespace torquewright::identification
