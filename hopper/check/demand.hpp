// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hopper/check/free_rows.hpp"
#include "hopper/contact/contact_schedule.hpp"
#include "hopper/robot/whole_body.hpp"

namespace torquewright::hopper {

/// A jump of the motion's velocities between two samples, and the impulses that make it.
struct Jolt {
  Eigen::Index sample = 0;  ///< The first after it.
  double time_s = 0.0;
  Eigen::VectorXd impulses_N_s;  ///< Three rows a contact point.
  Eigen::VectorXd contact_Nm_s;  ///< By drive, at its output: J^T of the impulses.
  Eigen::VectorXd rotor_Nm_s;    ///< By drive: what changes its rotor's speed.
  Eigen::VectorXd drive_Nm_s;    ///< By drive: what else the jump asks of its motor. Zero where
                                 ///< the jump is one of rigid bodies without motors.
  double lost_energy_J = 0.0;
  Eigen::VectorXd residual;  ///< By free row: impulse that no contact can give.
};

/// What a motion asks of the ground and of every actuator.
struct Demand {
  std::vector<std::vector<DriveInstant>> drives;  ///< By drive, then by sample; torque by dynamics.
  Eigen::MatrixXd contact_Nm;      ///< By drive and sample: at its output, of the contact forces.
  Eigen::MatrixXd file_torque_Nm;  ///< By drive and sample; empty where the file has not all.
  Eigen::MatrixXd joint_effort;    ///< By joint and sample: of the dynamics, rotors included.
  Eigen::MatrixXd forces_N;        ///< Three rows a contact point.
  /// By free row (FreeRows) and sample: what neither gravity nor inertia nor contacts explain.
  Eigen::MatrixXd residual;
  RowKinds rows;
  Eigen::MatrixXd center_of_mass_m;        ///< Three rows, world's axes; so the next two.
  Eigen::MatrixXd angular_momentum_Nm_s;   ///< CAM.
  Eigen::MatrixXd angular_velocity_rad_s;  ///< CAV.
  std::vector<Jolt> jolts;
  double weight_N = 0.0;
  double size_m = 0.0;       ///< Radius of gyration of all bodies at the first sample.
  std::size_t unsolved = 0;  ///< Samples whose contact forces rounding left inexact.
  bool has_dynamics = true;  ///< False: only the file's torques.
  bool is_shared = false;    ///< Contact forces were not unique: the shortest were taken.
};

/// Requires a motion whose rates are derived. Throws io::SpecError where a mechanism does not reach
/// a posture of the motion, naming time and angles.
Demand demand_of(const Robot& robot, const Motion& motion, const ContactSchedule& contacts,
                 const std::function<void(double share)>& on_progress = {});

}  // namespace torquewright::hopper
