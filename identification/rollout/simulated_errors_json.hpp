// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "identification/rollout/simulated_errors.hpp"

namespace torquewright::identification {

/// The errors as "simulated" in a report of identification, in rad.
nlohmann::ordered_json simulated_json(const SimulatedErrors& errors);

/// Root mean squares of windows: {"train_rms", "holdout_rms", "diverged"}.
nlohmann::ordered_json errors_json(const Rollout& rollout);

}  // namespace torquewright::identification
