// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "identification/rollout/value_fit.hpp"

namespace torquewright::identification {

/// A number of a body that may be off, alone, by so much.
struct LoadReading {
  FreeValue which;
  std::string body;
  double change = 0.0, standard_error = 0.0;
};

/// An error of a limb's bodies. The log cannot tell which of the readings it is.
struct LoadError {
  std::size_t limb = 0;
  std::vector<LoadReading> readings;  ///< The best first.
  double sigmas = 0.0;
};

/// How many of a limb's numbers (mass and centre of each body) the motion tells.
struct LoadRank {
  std::vector<std::string> bodies;
  std::size_t told = 0, of = 0;
};

struct LoadErrors {
  std::vector<LoadError> errors;
  std::vector<LoadRank> limbs;  ///< In the order of limbs_of().
};

/// Reads errors of masses and centres out of a fit that left them free (body_values()). What the
/// runs say of a limb's bodies, apart from everything else in the fit, is a quadratic form whose
/// null space no motion of this log tells: each error is the one number that takes most of it, with
/// the other numbers that would take nearly as much in its place.
LoadErrors load_errors(const RobotModel& stated, const ValueFit& fit);

/// "calf weighs 0.09 kg more, or its centre lies 6 mm further along its z: the log cannot tell
/// which."
std::string sentence_of(const LoadError& error);

}  // namespace torquewright::identification
