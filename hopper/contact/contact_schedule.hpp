// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// When a contact point counts as touching, where the motion does not say.
struct ContactThresholds {
  double height_m = 2e-3;  ///< It is no higher above the ground than this,
  double speed_m_s = 0.1;  ///< and moves no faster up or down.
};

/// The highest that any motion's points are tried at, the radius of a foot: what touches by a file
/// may lie so high where nothing is stated.
constexpr double kHighestTouch_m = 32e-3;

/// What is said of that: the rest is searched for (hopper/check/contact_search.hpp).
struct ContactRule {
  double ground_height_m = 0.0;
  std::optional<double> height_m;
  std::optional<double> speed_m_s;
  /// Time constant of soft ground: MuJoCo's default solref, critically damped.
  double time_constant_s = 0.02;

  /// Those stated, and of the others the usual ones.
  ContactThresholds thresholds() const;
  bool is_stated() const { return height_m && speed_m_s; }
};

/// (points x samples), points in the robot's order.
using Touching = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// All (points x samples), points in the robot's order.
struct ContactSchedule {
  Touching touches;
  /// Where a point may press: where it touches and, if accelerations are derived, while it lets go
  /// for less than 10 ms, and before and after as many samples as they look to either side and one
  /// more; not across impacts. Empty: where it touches.
  Touching presses;
  ContactThresholds thresholds;
  bool is_searched = false;        ///< Whether they were searched for,
  double unexplained_share = 0.0;  ///< and what they leave, rms: unexplained_shares().
  Eigen::MatrixXd height_m;   ///< Above the ground; empty where the base's motion is not known.
  Eigen::MatrixXd speed_m_s;  ///< Upwards; empty where touching is given.
  /// Where given forces guide: those, spread over samples as the derived accelerations are.
  Eigen::MatrixXd guide_N;
  Eigen::MatrixXd guide_doubt_N;  ///< (points x samples): how far they may be off by that.
  double near_ground_m = 0.0;     ///< No higher above it than this a point may feel an impact.
  Origin origin = Origin::kDerived;

  bool any(Eigen::Index sample) const { return touches.col(sample).any(); }
  bool may_press(Eigen::Index point, Eigen::Index sample) const {
    return presses.size() > 0 ? presses(point, sample) : touches(point, sample);
  }
};

/// Finds touch-downs that stop a contact point (adding them to the motion's breaks), derives what
/// rates the motion lacks, and tells which points touch when. As the motion says it (a force that
/// is not zero, a contact column), else by the rule's thresholds.
ContactSchedule schedule_contacts(const Robot& robot, const ContactRule& rule, Motion& motion);

/// Which points touch, by their heights and speeds.
Touching touching_by(const ContactThresholds& thresholds, const ContactSchedule& schedule);

/// Sets the guide where the motion's forces are one. A force that jumps anywhere between two
/// samples is off by at most half its jump there.
void guide_by_forces(const Motion& motion, ContactSchedule& schedule);

/// Where they may press; see ContactSchedule.
Touching pressing(const Touching& touches, const Motion& motion);

}  // namespace torquewright::hopper
