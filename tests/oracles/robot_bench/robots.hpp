// SPDX-License-Identifier: Apache-2.0
// Which robot hangs there: public ones, those of this project's documents, drawn ones.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/draws.hpp"
#include "tests/oracles/robot_bench/robot.hpp"

namespace torquewright::oracles::robot_bench {

using mujoco_bench::Draws;

/// What a class asks of a robot.
struct Wanted {
  bool floats = false, alike = false;
};

/// $TORQUEWRIGHT_DATA, or ../shared/data beside the project. It need not exist.
std::filesystem::path data_folder();

/// Public models (robots/..., logs/... below `data`) where they are there, else drawn ones.
Robot draw_robot(Draws& draws, const Wanted& wanted, const std::filesystem::path& data);

/// A robot document's bodies and joints, without its mechanisms.
Robot robot_of_document(const nlohmann::json& document);

/// Bodies are rods of drawn length and mass. A number of equal limbs below a trunk.
Robot drawn_legs(Draws& draws, int legs, int joints_per_leg);
Robot drawn_arm(Draws& draws, int joints);

}  // namespace torquewright::oracles::robot_bench
