// SPDX-License-Identifier: Apache-2.0
#include "hopper/check/time_gap.hpp"

#include "actuator/check/time_gap.hpp"
#include "io/faults/refusal.hpp"

namespace torquewright::hopper {

actuator::LongestStep longest_step(const Motion& motion) {
  actuator::LongestStep longest;
  for (Eigen::Index i = 0; i + 1 < motion.samples(); ++i) {
    if (motion.step_s(i) <= longest.duration_s) continue;
    longest.duration_s = motion.step_s(i);
    longest.from_s = motion.time_s(i);
  }
  if (motion.samples() > 2) {
    longest.usual_s =
        (motion.duration_s() - longest.duration_s) / static_cast<double>(motion.samples() - 2);
  }
  return longest;
}

void require_seen_rates(const Motion& motion) {
  const bool no_velocity = motion.velocity_origin != Origin::kGiven;
  // Where the base does not move nothing asks for accelerations.
  const bool no_acceleration = motion.has_base && motion.acceleration_origin != Origin::kGiven;
  if (!no_velocity && !no_acceleration) return;
  const actuator::LongestStep step = longest_step(motion);
  if (!actuator::hides_motion(step)) return;
  io::refuse(motion.file, actuator::hidden_motion_sentence(
                              step, motion.clock.origin_s(),
                              no_velocity ? "velocities and accelerations" : "accelerations"));
}

}  // namespace torquewright::hopper
