// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/identification/robot/leg.hpp"

namespace torquewright::test {

/// Two legs of leg.hpp on one body, "left_" and "right_" before their names.
inline nlohmann::json two_legs_json(const std::vector<LegJoint>& joints) {
  const nlohmann::json one = leg_json(joints);
  nlohmann::json robot = one;
  robot["bodies"] = {one["bodies"][0]};
  robot["joints"] = nlohmann::json::array();
  for (const std::string side : {"left_", "right_"}) {
    for (std::size_t i = 1; i < one["bodies"].size(); ++i) {
      nlohmann::json body = one["bodies"][i];
      body["name"] = side + body["name"].get<std::string>();
      robot["bodies"].push_back(body);
      nlohmann::json joint = one["joints"][i - 1];
      joint["name"] = side + joint["name"].get<std::string>();
      joint["child"] = body["name"];
      if (i > 1) joint["parent"] = side + joint["parent"].get<std::string>();
      robot["joints"].push_back(joint);
    }
  }
  return robot;
}

}  // namespace torquewright::test
