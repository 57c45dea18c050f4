// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "actuator/region/operating_conditions.hpp"
#include "hopper/trials/randomisation.hpp"
#include "robot/model/robot.hpp"

namespace torquewright::hopper {

/// Numbers that one trial drew. Bodies, joints and drives are in the robot's order; drives as in
/// drive_names, joints by the bodies after the base.
struct Trial {
  std::uint64_t seed = 0;
  std::size_t number = 0;
  Eigen::VectorXd mass_factor;              ///< (bodies x 1)
  Eigen::VectorXd inertia_factor;           ///< (bodies x 1)
  Eigen::Matrix3Xd center_of_mass_shift_m;  ///< (3 x bodies), in each body's axes.
  /// (drives x 1), factors on the torque that feedback asks for.
  Eigen::VectorXd controller_gain_factor;
  Eigen::VectorXd motor_strength_factor;       ///< (drives x 1)
  Eigen::VectorXd further_friction_Nm;         ///< (drives x 1)
  std::optional<double> friction_coefficient;  ///< Friction of the ground; none: the contacts' own.
  std::optional<double> restitution;
  double ground_height_m = 0.0;  ///< Added to where the replay has it; so the next.
  double latency_s = 0.0;
  std::optional<double> state_of_charge;
  double bus_voltage_factor = 1.0;
  std::optional<double> winding_temperature_K;
  Eigen::VectorXd initial_joint_position_rad;    ///< (joints x 1), 0 for joints that slide.
  Eigen::VectorXd initial_joint_velocity_rad_s;  ///< (joints x 1)
};

/// Depends on seed and number alone, not on the trials before. Each number comes from a counter
/// (counted_random.hpp) behind the quantity's and the thing's name: a key more, a body more or
/// another order of the document moves no other number. Requires that require_fits has passed.
Trial draw_trial(const Randomisation& randomisation, const Robot& robot, std::uint64_t seed,
                 std::size_t number);

/// The robot of the trial: masses, inertias, centres of mass, contacts, voltages of its drives (but
/// not Robot::battery, the document's text). Rotors stay. Inertias of real bodies stay such:
/// scaling one about its centre of mass keeps its principal moments in proportion, and moving the
/// centre leaves it alone.
Robot perturbed(const Robot& robot, const Trial& trial);

/// Charge and winding temperature as drawn, the rest as given, for the drives of the perturbed
/// robot. A given bus voltage takes the drawn factor; a drawn charge takes its place.
actuator::OperatingConditions conditions_of(const Trial& trial,
                                            actuator::OperatingConditions conditions);

}  // namespace torquewright::hopper
