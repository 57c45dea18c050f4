// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// Thresholds by which a contact point counts as touching, where the motion does not say.
struct ContactThresholds {
  double height_m = 2e-3;  ///< Greatest height above the ground.
  double speed_m_s = 0.1;  ///< Greatest speed up or down.
};

/// Greatest height at which points are tried as touching, the radius of a foot: a point that
/// touches by a file may be so high where no height is stated.
constexpr double kHighestTouch_m = 32e-3;

/// What the user stated about contacts; the rest is searched for
/// (hopper/demand/contact_search.hpp).
struct ContactRule {
  double ground_height_m = 0.0;
  std::optional<double> height_m;
  std::optional<double> speed_m_s;
  /// Time constant of soft ground: MuJoCo's default solref, critically damped.
  double time_constant_s = 0.02;

  /// Returns the stated thresholds, and the usual ones for the rest.
  ContactThresholds thresholds() const;
  bool is_stated() const { return height_m && speed_m_s; }
};

/// (points x samples), points in the robot's order.
using Touching = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic>;

/// When contact points touch; tables are (points x samples), points in the robot's order.
struct ContactSchedule {
  Touching touches;
  /// When a point may press: where it touches and, if accelerations are derived, while it lets go
  /// for less than 10 ms, and before and after as many samples as they look to either side and one
  /// more; not across impacts. Empty: where it touches.
  Touching presses;
  ContactThresholds thresholds;
  bool is_searched = false;        ///< Whether the thresholds were searched for.
  double unexplained_share = 0.0;  ///< What they leave unexplained, rms: unexplained_shares().
  /// Height above the ground; empty where the base's motion is not known.
  Eigen::MatrixXd height_m;
  Eigen::MatrixXd speed_m_s;  ///< Speed upwards; empty where touching is given.
  /// Given forces that guide the solution, spread over samples as the derived accelerations are.
  Eigen::MatrixXd guide_N;
  /// (points x samples): how far the guide may be off by that spreading.
  Eigen::MatrixXd guide_doubt_N;
  double near_ground_m = 0.0;  ///< A point may feel an impact no higher above the ground than this.
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

/// Returns which points touch, by their heights and speeds.
Touching touching_by(const ContactThresholds& thresholds, const ContactSchedule& schedule);

/// Sets the guide where the motion gives forces. A force that jumps anywhere between two samples is
/// off by at most half its jump there.
void guide_by_forces(const Motion& motion, ContactSchedule& schedule);

/// Returns where points may press; see ContactSchedule.
Touching pressing(const Touching& touches, const Motion& motion);

}  // namespace torquewright::hopper
