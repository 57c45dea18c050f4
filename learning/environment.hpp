// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace torquewright::learning {

/// What one action led to.
struct Outcome {
  std::vector<double> rewards;  ///< One per value head, all finite.
  bool ended = false;           ///< The task is over here: nothing is earned beyond.
  bool cut = false;             ///< Only the time is up: the value of what comes counts.
};

/// One copy of a task. One object serves one thread at a time.
class Environment {
 public:
  virtual ~Environment() = default;
  /// Begins the episode of that number; equal (seed, episode) begin and go on alike, whatever was
  /// before: a resumed run begins its open episodes again and acts as it had.
  virtual void begin(std::uint64_t seed, std::uint64_t episode) = 0;
  /// Writes what the actor sees and what the critic sees (sizes of Sizes). Asked also after an
  /// action that ended the episode in `cut`, before the next begin().
  virtual void observe(Eigen::Ref<Eigen::VectorXd> actor,
                       Eigen::Ref<Eigen::VectorXd> critic) const = 0;
  /// Acts for one control period. The action is the policy's own, unbounded; what it means is the
  /// environment's.
  virtual Outcome act(const Eigen::Ref<const Eigen::VectorXd>& action) = 0;
};

/// Numbers that the actor sees, that the critic sees, that an action has, and rewards of a step.
struct Sizes {
  int actor_inputs = 0;
  int critic_inputs = 0;
  int actions = 0;
  int heads = 1;
};

/// Makes the copy of that number (0, 1, ...). Called from one thread.
using MakeEnvironment = std::function<std::unique_ptr<Environment>(int copy)>;

}  // namespace torquewright::learning
