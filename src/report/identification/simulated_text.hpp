// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "identification/rollout/simulated_errors.hpp"

namespace torquewright::report {

/// A table of how far the simulated robot is from its log: by length of window, and by joint.
std::string simulated_text(const identification::SimulatedErrors& errors);

}  // namespace torquewright::report
