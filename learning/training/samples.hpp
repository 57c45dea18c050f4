// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "learning/environment.hpp"

namespace torquewright::learning {

/// A state that no sample begins in, but whose value counts: where an episode was cut, and where
/// the iteration ends.
struct ViewBeyond {
  int sample = 0;  ///< That led to it.
  Eigen::VectorXf critic_view;
};

/// What happened in one iteration. Step t of copy c is sample c steps + t. Observations are as the
/// environment gave them.
struct Samples {
  Samples(const Sizes& sizes, int copy_count, int steps_of_copy, int guesses);

  int count() const { return copies * steps; }
  /// The samples' views beyond of one copy are its own list; only the first `beyond_count` count.
  ViewBeyond& add_beyond(int copy, int sample, Eigen::Index critic_inputs);

  int copies;
  int steps;                     ///< Of each copy.
  Eigen::MatrixXf actor_views;   // (actor inputs x samples)
  Eigen::MatrixXf critic_views;  // (critic inputs x samples)
  Eigen::MatrixXf guesses;       // (estimated x samples): the estimator's, as the actor saw them
  Eigen::MatrixXf means;         // (actions x samples)
  Eigen::MatrixXf actions;       // (actions x samples)
  Eigen::MatrixXd rewards;       // (samples x heads)
  std::vector<char> goes_on;     ///< Not 0: the next sample of the copy is of the same episode.
  std::vector<std::vector<ViewBeyond>> beyond;  ///< Of each copy, in order of time; kept memory.
  std::vector<std::size_t> beyond_count;

  Eigen::MatrixXd values;               // (samples x heads)
  Eigen::MatrixXd next_values;          // (samples x heads), 0 where the episode ended
  Eigen::MatrixXd advantages_of_heads;  // (samples x heads)
  Eigen::VectorXf advantages;           // (samples x 1): added, then of mean 0 and deviation 1
  Eigen::MatrixXf targets;              // (heads x samples): what the critics' outputs are to be
};

}  // namespace torquewright::learning
