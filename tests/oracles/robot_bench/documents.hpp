// SPDX-License-Identifier: Apache-2.0
// The files of a log: what was measured, what is stated, what is true.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tests/oracles/robot_bench/situation.hpp"

namespace torquewright::oracles::robot_bench {

Json robot_document(const Situation& it);
Json rig_document(const Situation& it);
Json truth_document(const Situation& it, std::uint64_t seed);
std::string log_text(const Situation& it, std::uint64_t seed);

/// log.csv, rig.json, robot.json, truth.json and, where there are drives, actuator_*.json.
void write_all(const Situation& it, std::uint64_t seed, const std::filesystem::path& folder);

}  // namespace torquewright::oracles::robot_bench
