// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/step_limit.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "hopper/replay/free_rotors.hpp"
#include "io/faults/refusal.hpp"
#include "robot/model/whole_body.hpp"
#include "simulation/joint/joint_model.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRadiansInAStep = 0.25;  // (0.25)^2/24 of the frequency: 0.3 %
constexpr double kDampedInAStep = 0.5;    // of the speed: more than 1 would turn it round

/// What each drive's output feels when it alone is pushed: 1/(a M^-1 a^T).
VectorXd felt_inertias_kg_m2(WholeBody& body) {
  const Index size = body.robot().tree.velocity_size();
  MatrixXd mass(size, size);
  body.mass_matrix(mass);
  const Eigen::LDLT<MatrixXd> solver(mass);
  const auto drives = static_cast<Index>(body.drive_count());
  VectorXd felt_kg_m2(drives);
  for (Index drive = 0; drive < drives; ++drive) {
    VectorXd force = VectorXd::Zero(size);
    body.add_drive_torques(VectorXd::Unit(drives, drive), force);
    felt_kg_m2[drive] = 1.0 / force.dot(solver.solve(force));
  }
  return felt_kg_m2;
}

/// So long a step may be for what couples one drive's output; infinite where nothing does.
double longest_step_s(const Robot& robot, const Drivetrain& drivetrain, std::size_t actuator,
                      double felt_kg_m2) {
  simulation::SimulationOptions options;
  options.motor_inertia_kg_m2 = is_rotor_free(robot, drivetrain, actuator)
                                    ? rotor_turned_kg_m2(robot, drivetrain, actuator)
                                    : 0.0;
  const simulation::JointModel model(drivetrain.actuators[actuator], felt_kg_m2, options);
  const double swing_1_s = std::sqrt(model.coupling_Nm_rad() / felt_kg_m2);
  const double damping_1_s = model.coupling_Nm_s_rad() / felt_kg_m2;
  return std::min(kRadiansInAStep / swing_1_s, kDampedInAStep / damping_1_s);
}

}  // namespace

void require_steps_follow_effects(const Robot& robot, const dynamics::VectorIn& position,
                                  double step_s) {
  const Robot moved = without_free_rotors(robot);
  WholeBody body(moved);
  if (!body.set(position, VectorXd::Zero(robot.tree.velocity_size()))) return;
  const VectorXd felt_kg_m2 = felt_inertias_kg_m2(body);
  Index drive = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (std::size_t i = 0; i < drivetrain.actuators.size(); ++i, ++drive) {
      const double longest_s = longest_step_s(robot, drivetrain, i, felt_kg_m2[drive]);
      if (step_s <= longest_s) continue;
      io::refuse("--step",
                 fmt::format("{:g} ms is too long for the effects of {}: what is stiff at its "
                             "output swings on in it by more than {:g} rad, or is damped by more "
                             "than {:g} of its speed; {:.3g} ms or less follows it, and what is "
                             "stiffer than matters may be left out of its document",
                             1e3 * step_s, drivetrain.actuator_names[i], kRadiansInAStep,
                             kDampedInAStep, 1e3 * longest_s));
    }
  }
}

}  // namespace torquewright::hopper
