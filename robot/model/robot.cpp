// SPDX-License-Identifier: Apache-2.0
#include "robot/model/robot.hpp"

#include <algorithm>

#include "actuator/region/torque_at.hpp"
#include "robot/mechanisms/loop.hpp"

namespace torquewright::hopper {

double rotor_at_output_kg_m2(const Drivetrain& drivetrain, std::size_t actuator) {
  const std::vector<double>& stated = drivetrain.stated_rotors_kg_m2;
  return stated.empty() ? actuator::reflected_inertia_kg_m2(drivetrain.actuators[actuator])
                        : stated[actuator];
}

double turned_at_output_kg_m2(const Drivetrain& drivetrain, std::size_t actuator) {
  const std::vector<double>& cranks = drivetrain.cranks_kg_m2;
  return rotor_at_output_kg_m2(drivetrain, actuator) + (cranks.empty() ? 0.0 : cranks[actuator]);
}

std::optional<std::size_t> Robot::find_joint(const std::string& joint_name) const {
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    if (tree.bodies[i].joint.name == joint_name) return i;
  }
  return std::nullopt;
}

double Robot::links_kg() const {
  double sum_kg = 0;
  const auto add = [&](const LoopGeometry& loop) {
    for (const dynamics::Body& body : loop.tree.bodies) sum_kg += body.inertia.mass_kg;
  };
  for (const Drivetrain& drivetrain : drivetrains) {
    const auto* loop = dynamic_cast<const Loop*>(drivetrain.mechanism.get());
    if (loop != nullptr) add(loop->geometry());
  }
  for (const Follower& follower : followers) add(follower.links->geometry());
  return sum_kg;
}

bool Robot::states_rotor(std::size_t body, const dynamics::Joint& joint) const {
  return joint.reflected_inertia != 0 ||
         std::find(without_rotor.begin(), without_rotor.end(), body) != without_rotor.end();
}

}  // namespace torquewright::hopper
