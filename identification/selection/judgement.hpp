// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/residual_structure.hpp"
#include "identification/selection/search.hpp"

namespace torquewright::identification {

/// Which of what a search found is certain.
struct Judgement {
  bool is_noise_before = false;
  bool has_tentative = false;

  /// True if nothing but noise is left.
  bool is_noise(const ModelFitter& fitter, const ModelFit& fit,
                const std::vector<ResidualStructure>& structure) const;
};

/// Takes from `found.best` what is not certain, and says so.
Judgement judge(const ModelFitter& fitter, Found& found,
                const std::vector<ResidualStructure>& structure_before);

}  // namespace torquewright::identification
