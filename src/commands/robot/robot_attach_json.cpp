// SPDX-License-Identifier: Apache-2.0
#include "src/commands/robot/robot_attach_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/documents/json_layout.hpp"
#include "io/files/file_bytes.hpp"
#include "src/commands/shared/moved_references_json.hpp"

namespace torquewright::cli {
namespace {

/// The mechanism that turns this joint alone; null if there is none.
nlohmann::ordered_json* mechanism_of(const std::string& joint, nlohmann::ordered_json& mechanisms) {
  for (nlohmann::ordered_json& each : mechanisms) {
    if (each["joints"] == nlohmann::ordered_json{joint}) return &each;
  }
  return nullptr;
}

}  // namespace

std::string robot_with_drives(const std::filesystem::path& robot,
                              const std::filesystem::path& place,
                              const std::vector<hopper::AttachedDrive>& attached) {
  auto document = nlohmann::ordered_json::parse(io::read_file_bytes(robot));
  move_robot(document, robot, place);
  nlohmann::ordered_json& mechanisms = document["mechanisms"];
  for (const hopper::AttachedDrive& each : attached) {
    if (nlohmann::ordered_json* known = mechanism_of(each.joint, mechanisms)) {
      (*known)["actuators"] = {each.file};
    } else {
      mechanisms.push_back(
          {{"type", "direct"}, {"joints", {each.joint}}, {"actuators", {each.file}}});
    }
  }
  return io::json_layout(document);
}

std::size_t count_own_rotors(const std::string& document,
                             const std::vector<hopper::AttachedDrive>& attached) {
  const auto root = nlohmann::json::parse(document);
  std::size_t count = 0;
  for (const nlohmann::json& joint : root["joints"]) {
    count += joint.contains("reflected_inertia_kg_m2") &&
             std::any_of(attached.begin(), attached.end(),
                         [&](const auto& each) { return joint["name"] == each.joint; });
  }
  return count;
}

}  // namespace torquewright::cli
