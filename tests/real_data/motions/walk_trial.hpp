// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tests/real_data/motions/walk_control.hpp"
#include "tests/real_data/motions/walk_plant.hpp"

namespace torquewright::test {

/// A walk over one planned impact, on ground or with a push that puts it elsewhere in time.
struct WalkTrial {
  std::size_t before = 1;        ///< Mode that the impact ends: on the right foot, the left lands.
  double ground_height_m = 0.0;  ///< Where the foot lands; that which stands is at 0.
  double swing_push_m_s = 0.0;   ///< Added to the swinging foot's vertical speed at the start.
  bool is_stepped = false;       ///< By stepping_plant(), on level ground, instead of held_plant().
  WalkControl::Settings control;
};

struct WalkSample {
  double time_s = 0.0;               ///< From the planned impact.
  Eigen::VectorXd torque_Nm;         ///< (4 x 1)
  Eigen::VectorXd rate_error_rad_s;  ///< Wanted less actual, as nothing is taken out (4 x 1).
};

struct WalkResult {
  std::vector<WalkSample> samples;  ///< One a control period, of 1 ms.
  bool has_landed = false;
  double contact_s = 0.0;  ///< From the planned impact: positive is late.
  /// From 1.5 windows before the planned impact to 50 ms after it and contact.
  double peak_torque_Nm = 0.0;
  /// Norm of the hip's and the knee's error of rates, root of its mean square over 50 ms after the
  /// planned impact and contact.
  double landing_leg_rad_s = 0.0;
  double other_leg_rad_s = 0.0;
};

WalkResult walk(const hopper::Robot& robot, const Walk& reference, const WalkTrial& trial);

/// The least change of velocities (least squares, m/s and rad/s alike) that keeps the stance foot
/// and moves the other one straight up: which one seed 003 took is not published.
Eigen::VectorXd swing_push(const hopper::Robot& robot, const WalkInstant& instant,
                           std::size_t stance, double speed_m_s);

}  // namespace torquewright::test
