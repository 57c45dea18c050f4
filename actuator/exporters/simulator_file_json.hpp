// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "actuator/exporters/simulator_file.hpp"

namespace torquewright::actuator {

/// A document of kind `simulator_file` without its provenance.
nlohmann::ordered_json simulator_file_json(const Subject& subject, const SimulatorFile& file);

}  // namespace torquewright::actuator
