// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"
#include "identification/selection/search.hpp"

namespace torquewright::identification {

/// Returns the equation with one of the values that every model fits held where it starts.
ForwardEquation held_at_start(ForwardEquation equation, std::size_t k);

/// Returns how many instants of samples an equation has.
std::size_t instants_of(const ForwardEquation& equation);

/// Returns the equation with so many of its instants free, and the others held at the middle of the
/// step.
ForwardEquation with_instants(ForwardEquation equation, std::size_t free);

/// Returns how many instants have to be free beside a model of `fitter`, whose equation has `free`
/// of them: more where they take from what the model leaves what a name would have to.
std::size_t instants_that_show(const ForwardEquation& all, std::size_t free,
                               const ModelFitter& fitter, const std::vector<Signals>& replica,
                               const SearchRules& rules, const ModelFit& model);

}  // namespace torquewright::identification
