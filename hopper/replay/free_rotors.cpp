// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/free_rotors.hpp"

#include "hopper/robot/whole_body.hpp"
#include "simulation/joint/elastic_train.hpp"

namespace torquewright::hopper {

double rotor_turned_kg_m2(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator) {
  if (!drivetrain.rotors_in_tree || rotors_stay_in_tree(drivetrain)) {
    return rotor_at_output_kg_m2(drivetrain, actuator);
  }
  return rotor_in_tree_kg_m2(robot, drivetrain);
}

bool is_rotor_free(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator) {
  return simulation::states_elastic_train(drivetrain.actuators[actuator]) &&
         !rotors_stay_in_tree(drivetrain) && rotor_turned_kg_m2(robot, drivetrain, actuator) > 0.0;
}

Robot without_free_rotors(const Robot& robot) {
  Robot engine = robot;
  for (Drivetrain& drivetrain : engine.drivetrains) {
    std::vector<double> kept_kg_m2;
    bool some_are_free = false;
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i) {
      const bool is_free = is_rotor_free(robot, drivetrain, i);
      kept_kg_m2.push_back(is_free ? 0.0 : rotor_at_output_kg_m2(drivetrain, i));
      some_are_free = some_are_free || is_free;
    }
    if (!some_are_free) continue;
    if (drivetrain.rotors_in_tree) {
      dynamics::Joint& joint = engine.tree.bodies[drivetrain.joints.front()].joint;
      joint.reflected_inertia = 0.0;
      joint.rotor_spin_kg_m2.setZero();
    } else {
      drivetrain.stated_rotors_kg_m2 = std::move(kept_kg_m2);
    }
  }
  return engine;
}

}  // namespace torquewright::hopper
