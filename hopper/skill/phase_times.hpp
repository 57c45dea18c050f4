// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::hopper {

/// Times of a motion that happens once, and the period of one that repeats; 0: it has none.
struct PhaseTimes {
  double take_off_s = 0.0;  ///< From here on it flies,
  double landing_s = 0.0;   ///< and until here.
  double end_s = 0.0;       ///< From here on nothing more happens.
  double period_s = 0.0;
};

}  // namespace torquewright::hopper
