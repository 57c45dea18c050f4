// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "hopper/training/rewards/reward_term.hpp"

// One line for each term; its file defines the constant of that name.
#define TORQUEWRIGHT_EVERY_REWARD(reward)                                                       \
  reward(cav) reward(cam) reward(bav) reward(linear_velocity) reward(torque)                    \
      reward(joint_position) reward(joint_speed) reward(joint_acceleration) reward(slip)        \
          reward(smooth_action) reward(contact_change) reward(contact_impulse)                  \
              reward(position_barrier) reward(speed_barrier) reward(load_barrier)               \
                  reward(upright_end) reward(still_end) reward(grounded) reward(further_flight) \
                      reward(fall) reward(follow) reward(missing_turn) reward(alive)            \
                          reward(forward_tracking) reward(yaw_tracking) reward(tilt)            \
                              reward(posture) reward(action_rate) reward(gait_barrier)          \
                                  reward(clearance_barrier) reward(height_barrier)              \
                                      reward(tracking_barrier) reward(mass_offset)

namespace torquewright::hopper::rewards {

#define TORQUEWRIGHT_DECLARE(name) extern const RewardTerm name;
TORQUEWRIGHT_EVERY_REWARD(TORQUEWRIGHT_DECLARE)
#undef TORQUEWRIGHT_DECLARE

}  // namespace torquewright::hopper::rewards
