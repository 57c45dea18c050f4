// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "hopper/training/rewards/reward_instant.hpp"

namespace torquewright::hopper {

/// How a term enters the rewards of a step:
/// motion = (1 + sum of factors) (sum of parts) + exp(0.2 sum of costs) (sum of gains) + sum of
/// extras, barrier = sum of barriers. The first product is seed 000's, the second seed 001's.
enum class RewardRole { kFactor, kPart, kGain, kCost, kExtra, kBarrier };

/// Numbers of a term in a task. What a term has no use for is not looked at.
struct RewardNumbers {
  double weight = 1.0;    ///< Dimensionless; negative: it is a cost.
  double rate = 1.0;      ///< In the exponent, per square of the term's unit.
  double least = 0.0;     ///< Ends of a barrier,
  double greatest = 0.0;  ///< in the term's unit.
  double softness = 1.0;  ///< How far inside an end its logarithm gives way to a parabola.
  Eigen::VectorXd joint_weight = {};  ///< By joint; as the next two, never empty in a task.
  Eigen::VectorXd joint_least = {};
  Eigen::VectorXd joint_greatest = {};
};

/// Where a term's ends by joint come from, unless a task states them.
enum class JointEnds {
  kNone,    ///< It has none.
  kRanges,  ///< The joints' ranges.
  kSame,    ///< RewardNumbers::least and greatest.
};

/// A term of the rewards, without its weight. Each is one file in this folder and one line in
/// every_reward.hpp.
struct RewardTerm {
  std::string_view name;
  std::string_view sentence;  ///< Description for a user, with its source or "ours".
  RewardRole role = RewardRole::kPart;
  RewardNumbers usual = {};  ///< Numbers as published; without weights by joint.
  JointEnds ends = JointEnds::kNone;
  double (*value)(const RewardInstant& at, const RewardNumbers& numbers) = nullptr;
};

}  // namespace torquewright::hopper
