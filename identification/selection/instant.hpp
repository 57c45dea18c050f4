// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "identification/forward/equation.hpp"

namespace torquewright::identification {

/// Returns the equation with one of the values that every model fits held where it starts.
ForwardEquation held_at_start(ForwardEquation equation, std::size_t k);

/// Returns the equation with the instants of its samples held at the middle of the step.
ForwardEquation without_instants(ForwardEquation equation);

}  // namespace torquewright::identification
