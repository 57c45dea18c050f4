// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"

namespace torquewright::identification {

/// An addition to a model that looks promising before it is fitted.
struct Prospect {
  EffectSet added;        ///< One, or more.
  Eigen::VectorXd start;  ///< Coordinates of the whole model with it.
  double loss = 0.0;      ///< Of the training rows, by the linear model.
};

struct Screening {
  std::vector<Prospect> singles, pairs;        ///< The most promising first.
  std::vector<Prospect> combs;                 ///< The most promising waves of one kind, together.
  std::vector<const EffectCandidate*> silent;  ///< The log does not move them.
};

/// Every candidate that the model does not hold, by linear least squares with the slopes of the
/// model and those of the candidate at each of its starts; then pairs of their best starts.
/// `least_change_rms`: what the largest sensible value of a parameter has to change, so that the
/// log is said to move it.
Screening screen(const ModelFitter& fitter, const ModelFit& model, const EffectSet& candidates,
                 double least_change_rms, bool with_pairs);

}  // namespace torquewright::identification
