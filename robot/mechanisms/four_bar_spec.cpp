// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "robot/mechanisms/every_mechanism.hpp"
#include "robot/mechanisms/four_bar.hpp"

namespace torquewright::hopper::mechanisms {
namespace {

constexpr double kTransmissionLimit = 0.52;  // 30 degrees, the usual least of textbooks

constexpr std::string_view kNeeds[] = {"crank_length_m",  "coupler_length_m", "rocker_length_m",
                                       "ground_length_m", "crank_zero_rad",   "rocker_zero_rad"};
constexpr std::string_view kMayState[] = {"crank_direction", "rocker_direction", "branch",
                                          "transmission_angle_limit_rad"};

std::shared_ptr<const Mechanism> read(const MechanismKeys& keys) {
  FourBarGeometry read;
  read.crank_m = keys.number("crank_length_m");
  read.coupler_m = keys.number("coupler_length_m");
  read.rocker_m = keys.number("rocker_length_m");
  read.ground_m = keys.number("ground_length_m");
  read.crank_zero_rad = keys.number("crank_zero_rad");
  read.rocker_zero_rad = keys.number("rocker_zero_rad");
  read.crank_direction = keys.keys.value("crank_direction", 1);
  read.rocker_direction = keys.keys.value("rocker_direction", 1);
  read.branch = keys.keys.value("branch", 1);
  read.transmission_limit_rad = keys.number("transmission_angle_limit_rad", kTransmissionLimit);
  if (!keys.turn_only()) return nullptr;
  if (const auto objection = four_bar_objection(read)) {
    keys.report("", *objection);
    return nullptr;
  }
  return std::make_shared<FourBar>(read);
}

nlohmann::ordered_json write(const Mechanism& mechanism) {
  const FourBarGeometry& geometry = dynamic_cast<const FourBar&>(mechanism).geometry();
  return {{"crank_length_m", geometry.crank_m},
          {"coupler_length_m", geometry.coupler_m},
          {"rocker_length_m", geometry.rocker_m},
          {"ground_length_m", geometry.ground_m},
          {"crank_zero_rad", geometry.crank_zero_rad},
          {"rocker_zero_rad", geometry.rocker_zero_rad},
          {"crank_direction", geometry.crank_direction},
          {"rocker_direction", geometry.rocker_direction},
          {"branch", geometry.branch},
          {"transmission_angle_limit_rad", geometry.transmission_limit_rad}};
}

}  // namespace

const MechanismType four_bar = {.name = "four_bar",
                                .joints = 1,
                                .needs = kNeeds,
                                .may_state = kMayState,
                                .read = read,
                                .write = write};

}  // namespace torquewright::hopper::mechanisms
