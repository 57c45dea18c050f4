// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "identification/log/runs.hpp"

namespace torquewright::identification {

/// A run with samples of its stretch before and behind it, where it is a piece of one. A run that
/// is a whole stretch stands alone.
struct Piece {
  Run run;
  std::size_t begin = 0;  ///< Its own samples ...
  std::size_t end = 0;    ///< ... end before this one.
};

/// With up to `around` samples on each side: of the neighbouring piece alone, and fewer where that
/// one is shorter.
Piece with_neighbours(const Runs& runs, std::size_t index, std::size_t around);

/// The same with these samples before it, if it continues.
Piece with_neighbours(const Runs& runs, std::size_t index, std::size_t around, const Run& before);

}  // namespace torquewright::identification
