// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/findings/residual_structure.hpp"
#include "identification/selection/search.hpp"
#include "identification/selection/steadiness.hpp"

namespace torquewright::identification {

/// An effect whose parameters differ between parts of the log, so that it is no law of this
/// actuator.
struct Wanderer {
  const EffectCandidate* candidate = nullptr;
  Unsteadiness by;
};

/// Which of a search's findings are certain.
struct Judgement {
  bool is_noise_before = false;
  bool has_tentative = false;
  std::vector<Wanderer> wanderers;
};

/// Returns the rms of what the channels' noise changes of a model's residual in the fitted rows:
/// the yardstick of what is left. Uncertain values that came out more than twice what is stated, or
/// less than half, count there as stated, so that no model is judged by a noise of its own making.
double noise_floor(const ModelFitter& fitter, const ModelFit& fit);

/// Whether a model leaves nothing but noise, by the size and the structure of its residual.
bool leaves_noise(const Search& search, const ModelFitter& fitter, const ModelFit& fit,
                  const std::vector<ResidualStructure>& structure);

/// Removes from `found.best` what is not certain, and says so in the result.
Judgement judge(const ModelFitter& fitter, Search& search, Found& found,
                const std::vector<ResidualStructure>& structure_before);

}  // namespace torquewright::identification
