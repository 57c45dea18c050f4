// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "hopper/tracking/contact_rows.hpp"
#include "robot/model/whole_body.hpp"

namespace torquewright::hopper {

/// Errors (2 n x 1, as in linearisation.hpp) that the ground leaves possible while some points hold
/// to it, up to where the robot stands and which way it faces: those change nothing that a drive
/// could mend. docs/derivations/tracking.md eqs. (8)-(11).
struct ErrorSpace {
  Eigen::MatrixXd from_free;  ///< (2 n x m): errors from the m that are free.
  /// (m x 2 n), a left inverse of from_free: what remains of any error once the ground has taken
  /// its part as an impulse would, and once place and heading are taken out.
  Eigen::MatrixXd to_free;
};

/// Directions of positions (n x k) that a world of flat ground does not feel: along x and y, and
/// about the vertical through the base's origin; of a planar base along x; of a fixed one none.
Eigen::MatrixXd unfelt_directions(const dynamics::TreeState& state);

/// Computes the space of free errors. None where a mechanism does not reach the posture.
std::optional<ErrorSpace> error_space(WholeBody& body, const Eigen::VectorXd& position,
                                      const Eigen::VectorXd& velocity,
                                      const TouchingPoints& touches);

/// The observed state turned and moved in the world so that it stands and faces as the reference
/// does, and its error; eq. (8).
struct AlignedError {
  Eigen::VectorXd position;  ///< Observed, aligned.
  Eigen::VectorXd velocity;
  Eigen::VectorXd error;  ///< (2 n x 1)
};
AlignedError aligned_error(const dynamics::Tree& tree, const ReferenceInstant& wanted,
                           const Eigen::VectorXd& position, const Eigen::VectorXd& velocity);

}  // namespace torquewright::hopper
