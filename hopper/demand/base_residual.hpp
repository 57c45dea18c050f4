// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/demand/checked_motion.hpp"

namespace torquewright::hopper {

/// The largest mean of a residual over a window, and where the window begins.
struct ResidualPeak {
  double mean = 0.0;  ///< Mean in N, or Nm.
  double limit = 0.0;
  double time_s = 0.0;
  double share_beyond = 0.0;  ///< Number of windows beyond the limit over the number of samples.
};

/// Force and moment that the motion needs and nothing gives. A real motion has none but what errors
/// and rounding of the trajectory make.
struct BaseResidual {
  ResidualPeak force;   ///< Force on a floating base.
  ResidualPeak moment;  ///< Moment about the centre of mass.
  /// Torque on joints that no actuator moves; forces of slides times size_m.
  ResidualPeak passive;
  double window_s = 0.0;
  /// The same on the base over a longer window, against a tenth of the limit of force and a fifth
  /// of that of moment: what topples keeps asking for little. There is no limit where the file
  /// gives the forces, which may be off by as much for as long.
  ResidualPeak lasting_force, lasting_moment;
  double lasting_window_s = 0.0;
};

/// Computes means over windows that begin at every sample, impulses of jolts included
/// (docs/derivations/whole_body_check.md eq. (11)).
BaseResidual base_residual(const CheckedMotion& checked);

/// Computes the same from another residual (free rows x samples) in place of the demand's.
BaseResidual base_residual(const CheckedMotion& checked, const Eigen::MatrixXd& left);

/// Returns the samples that ask for more than a limit in a window whose mean does, ascending.
std::vector<Eigen::Index> samples_beyond(const CheckedMotion& checked,
                                         const BaseResidual& residual);

}  // namespace torquewright::hopper
