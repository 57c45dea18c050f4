// SPDX-License-Identifier: Apache-2.0
#include "hopper/training/episode/reward_sum.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace torquewright::hopper {
namespace {

/// Of seed 001's standard reward.
constexpr double kCostRate = 0.2;

[[noreturn]] void refuse(const RewardTerm& term, const RewardInstant& at) {
  throw std::domain_error(fmt::format(
      "the reward {} is no number at t = {:.4g} s: base {:.4g} m high, turned by {:.4g} rad, at "
      "{:.4g} m/s; joints at {:.4g} rad, {:.4g} rad/s, with {:.4g} Nm",
      term.name, at.time_s, at.base_height_m, at.turned_rad, at.base_velocity_m_s.norm(),
      fmt::join(at.joint_rad, ", "), fmt::join(at.joint_rad_s, ", "),
      fmt::join(at.joint_Nm, ", ")));
}

}  // namespace

std::vector<double> rewards_of(const std::vector<ReadyReward>& rewards, const RewardInstant& at) {
  std::array<double, 6> sums{};
  for (const ReadyReward& reward : rewards) {
    const double value = reward.numbers.weight * reward.term->value(at, reward.numbers);
    if (!std::isfinite(value)) refuse(*reward.term, at);
    sums[static_cast<std::size_t>(reward.term->role)] += value;
  }
  const auto sum = [&sums](RewardRole role) { return sums[static_cast<std::size_t>(role)]; };
  const double motion = (1.0 + sum(RewardRole::kFactor)) * sum(RewardRole::kPart) +
                        std::exp(kCostRate * sum(RewardRole::kCost)) * sum(RewardRole::kGain) +
                        sum(RewardRole::kExtra);
  return {motion, sum(RewardRole::kBarrier)};
}

}  // namespace torquewright::hopper
