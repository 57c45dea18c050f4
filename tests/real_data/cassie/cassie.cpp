// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/cassie/cassie.hpp"

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "io/documents/document.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::test {
namespace {

std::filesystem::path data_file(const char* name) {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const std::filesystem::path data =
      variable != nullptr ? std::filesystem::path(variable)
                          : std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  const std::filesystem::path file = data / name;
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

std::string actuator_file(const std::string& name) {
  return TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/cassie_" + name + ".json";
}

/// The drives that turn a joint alone; those of the toes turn a linkage too and are there already.
void add_direct_drives(nlohmann::ordered_json& robot) {
  constexpr std::array<std::array<const char*, 2>, 4> kDrives{{{"hip-roll", "hip_roll_yaw"},
                                                               {"hip-yaw", "hip_roll_yaw"},
                                                               {"hip-pitch", "knee"},
                                                               {"knee", "knee"}}};
  for (const char* side : {"left-", "right-"}) {
    for (const auto& [joint, drive] : kDrives) {
      nlohmann::ordered_json mechanism;
      mechanism["type"] = "direct";
      mechanism["joints"] = {std::string(side) + joint};
      mechanism["actuators"] = {actuator_file(drive)};
      robot["mechanisms"].push_back(mechanism);
    }
  }
}

}  // namespace

std::filesystem::path cassie_file() { return data_file("robots/agility_cassie/cassie.xml"); }

std::filesystem::path published_jump_file() { return data_file("trajectories/cassie/jump.csv"); }

hopper::Robot cassie() {
  hopper::Robot robot = hopper::read_mjcf(cassie_file(), {}).robot;
  for (hopper::Drivetrain& drivetrain : robot.drivetrains) {
    drivetrain.actuator_files.assign(drivetrain.joints.size(), actuator_file("toe"));
  }
  nlohmann::ordered_json document = hopper::robot_json(robot);
  add_direct_drives(document);
  return hopper::robot_of(
             io::check_document(nlohmann::json::parse(document.dump()), "robot", "cassie.json", ""))
      .robot;
}

}  // namespace torquewright::test
