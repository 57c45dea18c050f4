// SPDX-License-Identifier: Apache-2.0
#include "identification/simulated/rig_plant.hpp"

#include <Eigen/Geometry>

#include "dynamics/gravity.hpp"
#include "identification/rig/load_inertia.hpp"
#include "simulation/plants/dynamometer.hpp"
#include "simulation/plants/serial_arm.hpp"
#include "simulation/plants/single_joint.hpp"
#include "simulation/plants/tree_plant.hpp"

namespace torquewright::identification {

std::vector<dynamics::SerialLink> serial_links_of(const Load& load) {
  std::vector<dynamics::SerialLink> links;
  for (const Link& link : load.links) {
    links.push_back({link.mass_kg, link.length_m, link.center_of_mass_m, link.inertia_kg_m2});
  }
  return links;
}

dynamics::Tree robot_tree_of(const Load& load) {
  dynamics::Tree tree = load.robot->tree;
  Eigen::Matrix3d& R_WB = tree.bodies.front().joint.R_PB;
  R_WB = (Eigen::AngleAxisd(load.roll_rad, Eigen::Vector3d::UnitX()) *
          Eigen::AngleAxisd(load.pitch_rad, Eigen::Vector3d::UnitY()))
             .toRotationMatrix() *
         R_WB;
  return tree;
}

Eigen::VectorXd held_positions_of(const Load& load) {
  Eigen::VectorXd position = Eigen::VectorXd::Zero(load.robot->tree.position_size());
  for (const auto& [body, held_rad] : load.robot->held_rad) {
    position[static_cast<Eigen::Index>(body) - 1] = held_rad;
  }
  return position;
}

std::unique_ptr<simulation::Plant> plant_of(const Load& load) {
  switch (load.type) {
    case LoadType::kFree:
    case LoadType::kLinearAxis:
      return std::make_unique<simulation::SingleJoint>(load_inertia_kg_m2(load));
    case LoadType::kPendulum:
      return std::make_unique<simulation::SingleJoint>(
          load_inertia_kg_m2(load), load.mass_kg * dynamics::kGravity_m_s2 * load.length_m);
    case LoadType::kSerialArm:
      return std::make_unique<simulation::SerialArm>(serial_links_of(load),
                                                     dynamics::kGravity_m_s2);
    case LoadType::kRobot:
      return std::make_unique<simulation::TreePlant>(robot_tree_of(load), load.robot->bodies,
                                                     held_positions_of(load));
    case LoadType::kDynamometer:
      break;
  }
  return std::make_unique<simulation::Dynamometer>();
}

}  // namespace torquewright::identification
