// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "tests/oracles/bench_log/bench.hpp"

namespace torquewright::oracles {

/// The nominal actuator as a document of kind actuator: what the truth has beyond it is not there.
nlohmann::json actuator_document(const Bench& bench);

/// How the log was taken, as a document of kind rig; the last two runs are held out.
nlohmann::json rig_document(const Bench& bench);

nlohmann::json truth_document(const Scenario& scenario);

}  // namespace torquewright::oracles
