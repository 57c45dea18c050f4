// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/check/checked_motion.hpp"

namespace torquewright::hopper {

/// The largest of a residual's means over the window, and where the window begins.
struct ResidualPeak {
  double mean = 0.0;  ///< N, or Nm.
  double limit = 0.0;
  double time_s = 0.0;
  double share_beyond = 0.0;  ///< Windows beyond the limit over all samples.
};

/// Force and moment that the motion needs and nothing gives: a motion of a body without wings has
/// none but what errors and rounding of the trajectory make.
struct BaseResidual {
  ResidualPeak force;    ///< On a floating base.
  ResidualPeak moment;   ///< About the centre of mass.
  ResidualPeak passive;  ///< Torque of joints that no actuator moves; forces of slides by size_m.
  double window_s = 0.0;
  /// The same on the base over a longer window, against a tenth of it, a fifth of the moment: what
  /// topples keeps asking for little. No limit where the file gives the forces, which may be off by
  /// as much for as long.
  ResidualPeak lasting_force, lasting_moment;
  double lasting_window_s = 0.0;
};

/// Means over windows that begin at every sample, impulses of jolts included.
/// docs/derivations/whole_body_check.md eq. (11).
BaseResidual base_residual(const CheckedMotion& checked);

/// The same of another residual (free rows x samples) in the place of the demand's.
BaseResidual base_residual(const CheckedMotion& checked, const Eigen::MatrixXd& left);

}  // namespace torquewright::hopper
