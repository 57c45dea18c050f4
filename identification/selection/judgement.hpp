// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/findings/residual_structure.hpp"
#include "identification/selection/search.hpp"
#include "identification/selection/steadiness.hpp"

namespace torquewright::identification {

/// An effect whose parameters do not hold in all parts of the log: no law of this actuator.
struct Wanderer {
  const EffectCandidate* candidate = nullptr;
  Unsteadiness by;
};

/// Which of what a search found is certain.
struct Judgement {
  bool is_noise_before = false;
  bool has_tentative = false;
  std::vector<Wanderer> wanderers;
};

/// Whether a model, and the structure that it leaves, leave nothing but noise.
bool leaves_noise(const Search& search, const ModelFitter& fitter, const ModelFit& fit,
                  const std::vector<ResidualStructure>& structure);

/// Takes from `found.best` what is not certain, and says so.
Judgement judge(const ModelFitter& fitter, Search& search, Found& found,
                const std::vector<ResidualStructure>& structure_before);

}  // namespace torquewright::identification
