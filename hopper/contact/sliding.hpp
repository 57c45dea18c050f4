// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/contact/contact_schedule.hpp"

namespace torquewright::hopper {

/// Which points slide over the ground, and which way.
struct Sliding {
  Eigen::MatrixXd velocity_m_s;  ///< (2 points x samples): of the touching points, world's x and y.
  /// (2 points x samples): unit vector of the mean velocity about the sample; 0: does not slide.
  Eigen::MatrixXd direction;

  bool slides(Eigen::Index point, Eigen::Index sample) const {
    return !direction.block<2, 1>(2 * point, sample).isZero(0.0);
  }
  bool any() const { return direction.size() > 0 && !direction.isZero(0.0); }
};

/// A point slides that touches for longer than the ground's time constant before and after a
/// sample, with no impact between, and moves along the ground on the mean of each of the two
/// faster than what counts as touching: soft ground would have stopped it by then if its friction
/// could. Requires a motion whose rates are derived.
Sliding find_sliding(const Robot& robot, const ContactRule& rule, const ContactSchedule& contacts,
                     const Motion& motion);

}  // namespace torquewright::hopper
