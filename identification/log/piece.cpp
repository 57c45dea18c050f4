// SPDX-License-Identifier: Apache-2.0
#include "identification/log/piece.hpp"

#include <algorithm>

#include "identification/log/stretch.hpp"

namespace torquewright::identification {

Piece with_neighbours(const Runs& runs, std::size_t index, std::size_t around) {
  if (!runs.head(index).continues) return with_neighbours(runs, index, around, {});
  const std::size_t samples = runs.head(index - 1).samples;
  const std::size_t begin = samples - std::min(samples, around);
  return with_neighbours(runs, index, around, runs.part(index - 1, begin, samples));
}

Piece with_neighbours(const Runs& runs, std::size_t index, std::size_t around, const Run& before) {
  Run own = runs.part(index, 0, runs.head(index).samples);
  Piece piece;
  piece.begin = own.continues ? before.masked.size() : 0;
  piece.end = piece.begin + own.masked.size();
  if (piece.begin > 0) {
    piece.run = before;
    piece.run.name = own.name;
    append(piece.run, own);
  } else {
    piece.run = std::move(own);
  }
  if (index + 1 < runs.size() && runs.head(index + 1).continues) {
    const std::size_t samples = runs.head(index + 1).samples;
    append(piece.run, runs.part(index + 1, 0, std::min(samples, around)));
  }
  return piece;
}

}  // namespace torquewright::identification
