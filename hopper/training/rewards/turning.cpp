// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/rewards/turning.hpp"

#include <algorithm>

namespace torquewright::hopper {

double paid_for_turning(const RewardInstant& at, double turning) {
  const PhaseTimes& phase = at.asked.phase;
  if (at.time_s < phase.take_off_s) return 0.0;
  if (at.time_s < phase.landing_s) return std::clamp(turning, -0.1, 10.0);
  if (phase.end_s > 0.0 && at.time_s >= phase.end_s) return 0.0;
  return -0.5 * std::min(at.momentum_Nm_s.norm(), 2.5);
}

}  // namespace torquewright::hopper
