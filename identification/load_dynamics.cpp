// SPDX-License-Identifier: Apache-2.0
#include "identification/load_dynamics.hpp"

#include <cmath>

#include "dynamics/gravity.hpp"
#include "identification/load_model.hpp"

namespace torquewright::identification {
LoadDynamics::LoadDynamics(const Rig& rig)
    : load_(rig.load), joints_(static_cast<Eigen::Index>(rig.joints.size())) {
  switch (load_.type) {
    case LoadType::kFree:
      inertia_kg_m2_ = load_.inertia_kg_m2;
      break;
    case LoadType::kLinearAxis:
      inertia_kg_m2_ = load_.mass_kg;
      break;
    case LoadType::kPendulum:
      inertia_kg_m2_ = load_.inertia_kg_m2 + load_.mass_kg * load_.length_m * load_.length_m;
      gravity_Nm_ = load_.mass_kg * dynamics::kGravity_m_s2 * load_.length_m;
      break;
    case LoadType::kSerialArm: {
      std::vector<dynamics::SerialLink> links;
      for (const Link& link : load_.links) {
        links.push_back({link.mass_kg, link.length_m, link.center_of_mass_m, link.inertia_kg_m2});
      }
      arm_ = std::make_unique<dynamics::SerialArm>(std::move(links), dynamics::kGravity_m_s2);
      break;
    }
    case LoadType::kDynamometer:
      break;
  }
}

void LoadDynamics::mass_matrix(const Eigen::VectorXd& position_rad, Eigen::MatrixXd& mass) const {
  if (arm_) {
    arm_->mass_matrix(position_rad, mass);
  } else {
    mass(0, 0) = inertia_kg_m2_;
  }
}

void LoadDynamics::bias(const Eigen::VectorXd& position_rad, const Eigen::VectorXd& speed_rad_s,
                        Eigen::VectorXd& torque_Nm) const {
  if (arm_) {
    arm_->bias(position_rad, speed_rad_s, torque_Nm);
  } else {
    torque_Nm[0] = gravity_Nm_ * std::sin(position_rad[0]);
  }
}

double LoadDynamics::energy_J(const Eigen::VectorXd& position_rad,
                              const Eigen::VectorXd& speed_rad_s) const {
  if (is_imposed()) return 0.0;
  if (arm_) {
    return arm_->kinetic_energy_J(position_rad, speed_rad_s) +
           arm_->potential_energy_J(position_rad);
  }
  return 0.5 * inertia_kg_m2_ * speed_rad_s[0] * speed_rad_s[0] -
         gravity_Nm_ * std::cos(position_rad[0]);
}

}  // namespace torquewright::identification
