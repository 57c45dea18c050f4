// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "tests/oracles/mujoco_bench/situation.hpp"

namespace torquewright::oracles::mujoco_bench {

nlohmann::ordered_json actuator_document(const Situation& it);
nlohmann::ordered_json rig_document(const Situation& it);
nlohmann::ordered_json truth_document(const Situation& it, std::uint64_t seed);

/// log.csv, rig.json, actuator.json, truth.json; the folder is made where it does not exist.
void write_all(const Made& made, std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace torquewright::oracles::mujoco_bench
