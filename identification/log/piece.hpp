// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "identification/log/runs.hpp"

namespace torquewright::identification {

/// A run with samples of its stretch before and behind it, where it is a piece of one. A run that
/// is a whole stretch has none.
struct Piece {
  Run run;
  std::size_t begin = 0;  ///< First of its own samples.
  std::size_t end = 0;    ///< One past its own last sample.
};

/// Returns the run with up to `around` samples on each side, from the neighbouring piece alone, and
/// fewer where that one is shorter.
Piece with_neighbours(const Runs& runs, std::size_t index, std::size_t around);

/// The same, with the samples of `before` in front of it if it continues that run.
Piece with_neighbours(const Runs& runs, std::size_t index, std::size_t around, const Run& before);

}  // namespace torquewright::identification
