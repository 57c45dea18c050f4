// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/motion/motion.hpp"

namespace torquewright::hopper {

/// When a contact point counts as touching, where the motion does not say.
struct ContactRule {
  double ground_height_m = 0.0;
  double height_m = 2e-3;  ///< It is no higher above the ground than this,
  double speed_m_s = 0.1;  ///< and moves no faster up or down.
};

/// All (points x samples), points in the robot's order.
struct ContactSchedule {
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> touches;
  Eigen::MatrixXd height_m;    ///< Above the ground; empty where the base's motion is not known.
  double near_ground_m = 0.0;  ///< No higher above it than this a point may feel an impact.
  Origin origin = Origin::kDerived;

  bool any(Eigen::Index sample) const { return touches.col(sample).any(); }
};

/// Finds touch-downs that stop a contact point (adding them to the motion's breaks), derives what
/// rates the motion lacks, and tells which points touch when. As the motion says it (a force that
/// is not zero, a contact column), else by the rule.
ContactSchedule schedule_contacts(const Robot& robot, const ContactRule& rule, Motion& motion);

}  // namespace torquewright::hopper
