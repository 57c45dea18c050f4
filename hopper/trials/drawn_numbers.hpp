// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "hopper/trials/trial.hpp"

namespace torquewright::hopper {

/// A number of a trial as it is shown to a user who asks why it fell.
struct DrawnNumber {
  std::string
      quantity;    ///< The document's key, which has the unit; "mass_factor" for both of mass.
  std::string of;  ///< Body, drive or joint, with the axis of a shift; empty: it holds for all.
  double value = 0.0;
};

/// Returns all numbers that were drawn, in the order of the document's keys and of the robot,
/// without noise. Requires a trial of this document and this robot.
std::vector<DrawnNumber> drawn_numbers(const Trial& trial, const Randomisation& randomisation,
                                       const Robot& robot);

}  // namespace torquewright::hopper
