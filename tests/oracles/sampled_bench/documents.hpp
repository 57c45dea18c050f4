// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/oracles/sampled_bench/classes.hpp"

namespace torquewright::oracles::sampled {

nlohmann::json actuator_document(const Situation& situation);
nlohmann::json rig_document(const Situation& situation);
nlohmann::json truth_document(const Bench& bench);
std::string log_csv(const Bench& bench);
/// log.csv, rig.json, actuator.json, truth.json.
void write_bench(const Bench& bench, const std::filesystem::path& folder);

}  // namespace torquewright::oracles::sampled
