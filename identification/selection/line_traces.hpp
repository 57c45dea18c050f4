// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "identification/findings/spectral_lines.hpp"
#include "identification/forward/equation.hpp"
#include "identification/preparation/held_signals.hpp"

namespace torquewright::identification {

/// Returns the residual of an equation under a hypothesis in the runs that are held, at the log's
/// own rate.
std::vector<LineTrace> line_traces(const ForwardEquation& equation, const Hypothesis& hypothesis,
                                   const HeldSignals& held);

}  // namespace torquewright::identification
