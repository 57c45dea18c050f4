// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "learning/environment.hpp"
#include "learning/generator.hpp"
#include "learning/training/iteration_report.hpp"
#include "learning/training/samples.hpp"

namespace torquewright::learning {

/// One environment, and how far its present episode is.
class Copy {
 public:
  Copy(std::unique_ptr<Environment> environment, const Sizes& sizes, std::uint64_t seed, int number,
       int copies);

  /// Writes what is seen now into that sample's columns.
  void observe(int sample, Samples& samples);
  /// Draws an action about the sample's mean, acts, and writes what came of it. At the copy's last
  /// step of the iteration what lies beyond is written too.
  void act(int sample, bool is_last, const Eigen::VectorXd& deviations, Samples& samples);

  /// The episodes that were over since the last call of forget_reports().
  const std::vector<EpisodeReport>& reports() const { return reports_; }
  void forget_reports() { reports_.clear(); }

  /// What there is to save: generator, number of the episode, its actions so far.
  std::uint64_t generator_state() const { return generator_.state(); }
  std::uint64_t episodes_begun() const { return begun_; }
  const std::vector<float>& actions_taken() const { return actions_taken_; }
  /// The last thing seen by actor and critic: to know an episode again.
  Eigen::VectorXd view();

  /// Begins that episode again and acts as it had.
  void go_on_from(std::uint64_t generator_state, std::uint64_t episodes_begun,
                  const std::vector<float>& actions_taken);

 private:
  void begin();
  void look();
  Outcome do_action(const Eigen::Ref<const Eigen::VectorXf>& action);
  std::string where() const;

  std::unique_ptr<Environment> environment_;
  std::uint64_t seed_;
  int number_;
  int copies_;
  Generator generator_;
  std::uint64_t begun_ = 0;
  EpisodeReport report_;
  std::vector<EpisodeReport> reports_;
  std::vector<float> actions_taken_;
  Eigen::VectorXd actor_view_;
  Eigen::VectorXd critic_view_;
  Eigen::VectorXd action_;
};

}  // namespace torquewright::learning
