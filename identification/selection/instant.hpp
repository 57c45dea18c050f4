// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/selection/model_fit.hpp"
#include "identification/selection/search.hpp"

namespace torquewright::identification {

/// Returns the equation with one of the values that every model fits held where it starts.
ForwardEquation held_at_start(ForwardEquation equation, std::size_t k);

/// Returns the equation without the instants of its samples: they are held at the middle of the
/// step.
ForwardEquation without_instants(ForwardEquation equation);

/// Whether the instants of the samples, within half a step of the log, take from what a model of
/// `without` leaves what a name would have to. `equation` is the same with the instants free. False
/// where it has none.
bool instants_show(const ForwardEquation& equation, const ModelFitter& without,
                   const std::vector<Signals>& replica, const SearchRules& rules,
                   const ModelFit& model);

}  // namespace torquewright::identification
