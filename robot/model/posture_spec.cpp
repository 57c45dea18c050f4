// SPDX-License-Identifier: Apache-2.0
#include "robot/model/posture_spec.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/documents/document.hpp"
#include "io/faults/json_text.hpp"
#include "robot/find_name.hpp"

namespace torquewright::hopper {

void read_postures(const io::Document& document, Robot& robot, std::vector<io::Fault>& faults) {
  const nlohmann::json postures = document.root.value("postures", nlohmann::json::object());
  const std::vector<dynamics::Body>& bodies = robot.tree.bodies;
  std::vector<std::string> joints;
  for (std::size_t i = 1; i < bodies.size(); ++i) joints.push_back(bodies[i].joint.name);
  for (const auto& entry : postures.items()) {
    const std::string path = io::child_path("/postures", entry.key());
    Posture posture{entry.key(), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(joints.size()))};
    for (const auto& joint : entry.value().items()) {
      const io::Fault place{document.file, io::child_path(path, joint.key()), ""};
      const auto index = find_name(joints, joint.key(), "joint", place, faults);
      if (!index) continue;
      const double position = joint.value();
      const dynamics::JointLimits& limits = bodies[*index + 1].joint.limits;
      if (position < limits.position_min || position > limits.position_max) {
        faults.push_back({place.file, place.path,
                          fmt::format("{} is outside the joint's range [{}, {}]", position,
                                      limits.position_min, limits.position_max)});
      }
      posture.joints[static_cast<Eigen::Index>(*index)] = position;
    }
    robot.postures.push_back(std::move(posture));
  }
}

}  // namespace torquewright::hopper
