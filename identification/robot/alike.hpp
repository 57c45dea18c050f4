// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/rollout/value_fit.hpp"

namespace torquewright::identification {

/// A number of one joint's drive, with what the log leaves open of it.
struct JointNumber {
  std::size_t joint = 0;
  double value = 0.0, standard_error = 0.0;
};

/// A joint that has not what its sisters have.
struct UnlikeJoint {
  JointNumber own;
  double sigmas = 0.0;  ///< From the sisters' mean, by the errors of both.
};

/// One number of joints of the same hardware.
struct AlikeNumber {
  std::string name;  ///< "rotor_inertia_kg_m2", "dry_friction_Nm at -2.3 rad".
  std::vector<JointNumber> joints;
  double value = 0.0;  ///< Common to those that are not unlike.
  /// Of the common value: by the joints' own errors, or by how they differ where that is more.
  double standard_error = 0.0;
  std::vector<UnlikeJoint> unlike;
};

/// What alike joints have in common, and which is not like its sisters: outside of all that they
/// have by more than they differ among themselves, and by 5 standard errors. Dry friction is
/// compared where the joints were: at the 5th, 50th and 95th of 100 of their positions. `groups`:
/// indices of the rig's joints, three at least in each that is looked at; `fit` moved values of
/// all.
std::vector<AlikeNumber> compare_alike(const Log& log, const ValueFit& fit,
                                       const std::vector<std::vector<std::size_t>>& groups);

}  // namespace torquewright::identification
