// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace torquewright::test {

/// A public robot with contact points and a direct drive in every joint, and how it hops: all
/// joints follow `stand + s(t) * fold`, s from 1 to `crouch` to `stretch` and back to 1.
struct PublicHopper {
  std::string name;
  std::string kind;  ///< Of robot, in words.
  hopper::Robot robot;
  std::vector<hopper::ContactPoint> stated_contacts;  ///< Of the file.
  std::map<std::string, double> stand;                ///< Joints that do not fold; others: 0 rad.
  std::map<std::string, double> fold;
  double crouch = 1.0;
  double stretch = 0.0;
  double spring_Nm_rad = 0.0;
  double damper_Nm_s_rad = 0.0;
};

/// Names of the five, one of them with two kinds of feet.
const std::vector<std::string>& public_hoppers();

/// None where the data are absent: ../shared/data or $TORQUEWRIGHT_DATA.
std::optional<PublicHopper> read_public_hopper(const std::string& name, bool keeps_passive = false);

}  // namespace torquewright::test
