// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/torque_doubt.hpp"
#include "hopper/check/transmission_load.hpp"
#include "hopper/demand/base_residual.hpp"
#include "hopper/demand/contact_load.hpp"
#include "hopper/demand/flights.hpp"

namespace torquewright::hopper {

/// Result of a check: whether a robot's actuators can do a motion.
struct HopperReport {
  actuator::CheckReport check;  ///< Verdict, drives and findings, as from actuator::check().
  BaseResidual base_residual;
  Eigen::MatrixXd torques_Nm;         ///< Torques that count, by drive and sample, rotors included.
  bool has_doubtful_torques = false;  ///< See DriveTorques::is_doubtful.
  GearTorque gears;
  std::vector<TransmissionLoad> transmission_loads;
  std::vector<ContactLoad> contact_loads;  ///< Empty without dynamics.
  std::vector<SharedBus> buses;
  std::vector<Flight> flights;
  std::vector<PeakDoubt> peak_doubts;  ///< By drive, where the dynamics' torques count.
  ContactSchedule contacts;
  Demand demand;
};

/// Checks a motion against its robot. The motion's missing rates are derived on the way. Throws
/// io::SpecError where it is no motion of this robot: a base residual beyond its limit, a posture
/// that a mechanism does not reach.
HopperReport check_motion(const Robot& robot, Motion& motion, const CheckOptions& options);

}  // namespace torquewright::hopper
