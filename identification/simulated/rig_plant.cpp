// SPDX-License-Identifier: Apache-2.0
#include "identification/simulated/rig_plant.hpp"

#include "dynamics/gravity.hpp"
#include "identification/rig/load_inertia.hpp"
#include "simulation/plants/dynamometer.hpp"
#include "simulation/plants/serial_arm.hpp"
#include "simulation/plants/single_joint.hpp"

namespace torquewright::identification {

std::vector<dynamics::SerialLink> serial_links_of(const Load& load) {
  std::vector<dynamics::SerialLink> links;
  for (const Link& link : load.links) {
    links.push_back({link.mass_kg, link.length_m, link.center_of_mass_m, link.inertia_kg_m2});
  }
  return links;
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
    case LoadType::kDynamometer:
      break;
  }
  return std::make_unique<simulation::Dynamometer>();
}

}  // namespace torquewright::identification
