// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "hopper/contact/contact_schedule.hpp"
#include "hopper/demand/free_rows.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Acceleration of gravity for limits that are shares of a weight: the robot's, or the Earth's
/// where it has none.
inline double gravity_of_limits_m_s2(const dynamics::Tree& tree) {
  return tree.gravity_m_s2 > 0.0 ? tree.gravity_m_s2 : 9.81;
}

/// A jump of the motion's velocities between two samples, and the impulses that make it: the
/// inverse of an impact (docs/derivations/whole_body_check.md eq. (10)).
struct Jolt {
  Eigen::Index sample = 0;  ///< First sample after the jump.
  double time_s = 0.0;
  Eigen::VectorXd impulses_N_s;  ///< Impulses of the points (3 points x 1), world's axes.
  /// Velocities before the jump of the points that may feel it (others 0), in the posture after it.
  Eigen::VectorXd before_m_s;
  /// Velocities after the jump; the impulses times the mean of both are the ground's work.
  Eigen::VectorXd after_m_s;
  /// (points x 1): by how much that velocity changes in the steps before and after the jump (in as
  /// many as derived rates look at), which is how well before and after are known.
  Eigen::VectorXd beside_m_s;
  Eigen::VectorXd contact_Nm_s;  ///< By drive, at its output: J^T of the impulses.
  Eigen::VectorXd rotor_Nm_s;  ///< By drive: impulse that changes its rotor's speed, at its output.
  Eigen::VectorXd drive_Nm_s;  ///< By drive: what else the jump asks of its motor. Zero where
                               ///< the jump is one of rigid bodies without motors.
  /// Energy lost by bodies and rotors; negative: the jump makes energy.
  double lost_energy_J = 0.0;
  Eigen::VectorXd residual;  ///< By free row: impulse that no contact can give.
};

/// What a motion asks of the ground and of every actuator. One column for each sample; rows by
/// drive as in WholeBody, by joint as the tree's bodies after the base, by free row as in FreeRows.
struct Demand {
  /// What each drive does, by drive, then by sample; its torque is from the dynamics.
  std::vector<std::vector<DriveInstant>> drives;
  /// (drives x samples): torque of the contact forces at the drive's output.
  Eigen::MatrixXd contact_Nm;
  /// (drives x samples): torques of the file; empty where it has not all.
  Eigen::MatrixXd file_torque_Nm;
  /// (drives x 1): inertia of rotors at their outputs, without gears.
  Eigen::VectorXd before_gears_kg_m2;
  /// (drives x samples), Nm s at the drive's output: what the velocities' changes since the sample
  /// before ask of it beyond what the samples' accelerations and contact forces do, eq. (18). 0
  /// where an impact lies between.
  Eigen::MatrixXd unsampled_Nm_s;
  /// (joints x samples), Nm or N: effort by the dynamics, rotors included.
  Eigen::MatrixXd joint_effort;
  Eigen::MatrixXd forces_N;  ///< (3 points x samples), world's axes.
  /// (free rows x samples), N and Nm: what neither gravity nor inertia nor contacts explain.
  Eigen::MatrixXd residual;
  /// (drives x samples): how far the torque may be off, because other forces of the points that
  /// press, within their cones, would move the base alike. Found at some 300 samples; 0 where
  /// forces are given or unique.
  Eigen::MatrixXd shared_doubt_Nm;
  /// (free rows x 1): standard deviation of the residual that the noise of derived accelerations
  /// makes, at the first sample's posture.
  Eigen::VectorXd residual_noise;
  RowKinds rows;
  /// Centre of mass (3 x samples), world's axes, as the next two.
  Eigen::MatrixXd center_of_mass_m;
  Eigen::MatrixXd angular_momentum_Nm_s;   ///< Angular momentum about the centre of mass (CAM).
  Eigen::MatrixXd angular_velocity_rad_s;  ///< Angular velocity of all bodies as one (CAV).
  /// (1 x samples): inertia of all bodies as one, about world's y through the centre of mass.
  Eigen::MatrixXd lateral_inertia_kg_m2;
  std::vector<Jolt> jolts;
  /// Samples whose values are read between those beside (hopper/check/left_out_rows.hpp),
  /// ascending.
  std::vector<Eigen::Index> left_out;
  double weight_N = 0.0;
  double size_m = 0.0;       ///< Radius of gyration of all bodies at the first sample.
  std::size_t unsolved = 0;  ///< Number of samples whose contact forces rounding left inexact.
  bool has_dynamics = true;  ///< False: only the file's torques are known.
  bool is_shared = false;    ///< Contact forces were not unique; the shortest were taken.
};

/// Computes the inverse dynamics sample by sample, eqs. (2)-(10). Requires a motion whose rates are
/// derived; `on_progress` is told the share that is done. Throws io::SpecError where a mechanism
/// does not reach a posture of the motion, naming time and angles.
Demand demand_of(const Robot& robot, const Motion& motion, const ContactSchedule& contacts,
                 const std::function<void(double share)>& on_progress = {});

/// Returns for each schedule what the free rows lack with the shortest forces of the points that
/// may press: root mean square over the samples, forces in weights and moments in weights times the
/// robot's size.
std::vector<double> unexplained_shares(const Robot& robot, const Motion& motion,
                                       const ContactSchedule& contacts,
                                       const std::vector<Touching>& schedules);

/// Returns the residual (free rows x samples) where some points slide (`direction`: 2 points x
/// samples, unit vectors or 0): what is left when they press with forces that only brake them, by
/// the whole friction coefficient times the normal force or as little of it as a pyramid has across
/// its edges, 1 over the root of 2 (docs/derivations/whole_body_check.md eq. (30)).
Eigen::MatrixXd left_by_sliding(const Robot& robot, const Motion& motion,
                                const ContactSchedule& contacts, const Eigen::MatrixXd& direction,
                                const Eigen::MatrixXd& residual);

}  // namespace torquewright::hopper
