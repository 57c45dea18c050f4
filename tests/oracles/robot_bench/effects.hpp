// SPDX-License-Identifier: Apache-2.0
// What may be missing at a joint, by the names of docs/effects.md.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/oracles/mujoco_bench/draws.hpp"
#include "tests/oracles/robot_bench/plant.hpp"

namespace torquewright::oracles::robot_bench {

using Json = nlohmann::ordered_json;

struct Effect {
  std::string name;
  std::vector<std::string> joints;
  Json parameters;
};

/// How a joint moves as stated: what sizes are drawn against.
struct Usage {
  double torque_Nm = 1, peak_Nm = 1, speed_rad_s = 1, top_speed_rad_s = 1;
  double low_rad = -1, high_rad = 1;

  double swing_rad() const { return 0.5 * (high_rad - low_rad); }
};

/// What an effect draws apart from its size.
struct Flavour {
  double a = 0.5, b = 0.5, sign = 1, order = 7, phase_rad = 0;
};

Flavour draw_flavour(mujoco_bench::Draws& draws);

std::vector<std::string> effect_names();

/// `scale` 1 is as much as a joint could reasonably have; all else follows from the flavour.
Json parameters_of(const std::string& name, double scale, const Flavour& flavour,
                   const Usage& usage, const Laws& stated);

/// Beyond what the laws hold.
void put_on(Laws& laws, const std::string& name, const Json& parameters);

/// As the documents call what is missing, first this name; then what is the same to any log of
/// positions under a stated loop.
std::vector<std::string> accepted_names(const std::string& name);

}  // namespace torquewright::oracles::robot_bench
