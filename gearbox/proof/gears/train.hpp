// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gearbox/problem.hpp"

namespace torquewright::gearbox::proof {

/// What the checker knows of a topology's parts. It shares none of it with the search, which has a
/// record of its own: docs/decisions/0001-checker-knows-topologies.md.
struct Train {
  std::string topology;                 ///< As in documents.
  std::vector<std::string> variables;   ///< Of proofs; those beyond are 0.
  std::vector<std::string> free_gears;  ///< The sun, then a planet of each layer.
  std::vector<std::string> rings;       ///< Of each layer.
  std::vector<std::string> meshes;      ///< The sun's, then the ring's of each layer.

  int layers() const { return static_cast<int>(rings.size()); }
  /// Two planets on one axle, of which the second has fewer teeth.
  bool is_stepped() const { return layers() > 1; }
  std::vector<std::string> gears() const;  ///< The free gears, then the rings.
};

/// Returns the train of the problem's topology. Throws std::invalid_argument where there is none:
/// the reader of problems refuses it.
const Train& train_of(const Problem& problem);

}  // namespace torquewright::gearbox::proof
