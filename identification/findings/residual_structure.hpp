// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/signals/signals.hpp"

namespace torquewright::identification {

/// A residual in its band, with the samples it belongs to.
struct ResidualTrace {
  const Signals* signals = nullptr;
  std::vector<std::size_t> index;  ///< Index of the sample of each value.
  std::vector<double> value;
  std::size_t fold = 0;
};

/// How much of a residual a smooth table over one coordinate explains where it was not fitted.
struct ResidualStructure {
  /// Name of the coordinate ("output_position_rad", ...), then what it is multiplied with.
  std::string coordinate;
  bool times_direction = false;
  double share = 0.0;          ///< R^2 on data that was not fitted; may be negative.
  double chance = 1.0;         ///< Probability that circular shifts within runs do as well.
  std::vector<double> centre;  ///< Centres of the bins.
  std::vector<double> level;   ///< Mean residual in each bin, over all folds.
};

struct ResidualStructureOptions {
  std::size_t bins = 16;
  std::size_t shifts = 39;
  double least_share = 0.05;
  double most_chance = 0.05;
  double smoothing_Hz =
      6.0;  ///< Coordinates that share noise with the residual are smoothed so far.
};

/// Returns the residual's structure over every coordinate, the strongest first
/// (docs/derivations/identification.md section 5).
std::vector<ResidualStructure> residual_structures(const std::vector<ResidualTrace>& traces,
                                                   const ResidualStructureOptions& options = {});

/// Whether a structure is beyond chance and large enough to speak of.
bool is_significant(const ResidualStructure& structure,
                    const ResidualStructureOptions& options = {});

}  // namespace torquewright::identification
