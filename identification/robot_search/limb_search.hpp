// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identification/robot_search/simulated_effect.hpp"

namespace torquewright::identification {

/// Where the search of one limb begins, and what it leads to.
struct LimbState {
  RobotModel stated;              ///< As known before the log: where values are held to.
  RobotModel model;               ///< As fitted.
  std::vector<FreeValue> values;  ///< That are free, of this limb's joints.
};

/// Searches one limb for effects that its simulation lacks (search_by_simulation): at most three,
/// one after another. `fits_first`: the model is no fit of the values as they stand. What is found
/// is appended to `search`, the names that were tried too.
LimbState search_limb(const Log& log, LimbState begin, std::size_t limb, bool fits_first,
                      const NamedByJoint& named,
                      const std::function<bool(const std::string&)>& asks, SimulatedSearch& search);

}  // namespace torquewright::identification
