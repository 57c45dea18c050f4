// SPDX-License-Identifier: Apache-2.0
#include "simulation/stepper/work_account.hpp"

#include "simulation/stepper/plant_motion.hpp"

namespace torquewright::simulation {

void WorkAccount::add(const PlantState& middle, const PlantMotion& motion,
                      const std::vector<JointModel>& models, bool is_imposed, double step_s) {
  for (std::size_t j = 0; j < models.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const JointState& joint = middle.joints[j];
    const JointForces& forces = motion.forces[j];
    const double motor_moved = step_s * joint.motor_speed_rad_s;
    const double moved = step_s * joint.speed_rad_s;
    const double ripple_Nm = forces.ripple_Nm + forces.ripple_ratio / (1.0 + forces.ripple_ratio) *
                                                    (motion.torque_Nm[row] - forces.ripple_Nm);
    const double through_Nm = motion.torque_Nm[row] - ripple_Nm;
    const double net_Nm =
        forces.before_mesh_Nm - models[j].inertia_kg_m2() * motion.motor_acceleration_rad_s2[row];
    motor_J += forces.motor_Nm * motor_moved;
    friction_J -= forces.friction_Nm * motor_moved;
    periodic_J += forces.cogging_Nm * motor_moved + ripple_Nm * moved;
    mesh_J += (net_Nm - through_Nm) * motor_moved;
    if (models[j].is_elastic()) {
      damper_J += models[j].twist(joint).damping_Nm * (motor_moved - moved);
    }
    if (is_imposed) load_J -= motion.torque_Nm[row] * moved;
  }
}

}  // namespace torquewright::simulation
