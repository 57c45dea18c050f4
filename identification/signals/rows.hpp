// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "identification/signals/signals.hpp"

namespace torquewright::identification {

constexpr std::size_t kHeldOut = static_cast<std::size_t>(-1);

/// Says what would help where too few samples are usable: of what leaves most of them out.
std::string what_would_help(const std::vector<Signals>& signals);

/// A function that returns a stretch's values, one for each sample.
using OfStretch = std::function<std::vector<double>(const Signals&)>;

/// The samples at which an equation is evaluated: the usable ones, below a cut-off, thinned, in
/// blocks of about equal time. Keeps a reference to the signals.
class Rows {
 public:
  struct Options {
    double cutoff_Hz = 8.0;
    double block_s = 1.5;
  };
  /// `fold_of_run` is by Signals::run; kHeldOut: no fit sees the run. With fewer than three folds
  /// runs are cut into contiguous ones.
  Rows(const std::vector<Signals>& signals, const std::vector<std::size_t>& fold_of_run,
       const Options& options);

  struct Block {
    Eigen::Index begin = 0, count = 0;  ///< Range of rows.
    std::size_t run = 0;
    std::size_t fold = 0;  ///< Fold of the block; kHeldOut: no fit sees it.
    bool is_held_out() const { return fold == kHeldOut; }
  };

  /// (n x 1) Returns the values below the cut-off at the rows. `like` are the signals, or a replica
  /// of them.
  Eigen::VectorXd values(const OfStretch& of_stretch, const std::vector<Signals>& like) const;
  Eigen::VectorXd values(const OfStretch& of_stretch) const { return values(of_stretch, signals_); }

  const std::vector<Signals>& signals() const { return signals_; }
  /// Indices of the rows' samples, by stretch.
  const std::vector<std::vector<std::size_t>>& samples() const { return samples_; }
  const std::vector<Block>& blocks() const { return blocks_; }
  std::size_t folds() const { return folds_; }
  bool cuts_runs() const { return cuts_runs_; }
  Eigen::Index count() const { return count_; }
  const Options& options() const { return options_; }
  std::size_t training_blocks() const;

 private:
  void cut(const Signals& stretch, std::size_t first_row, std::size_t rows, double block_s,
           std::size_t fold);
  void cut_runs_into_folds();

  const std::vector<Signals>& signals_;
  Options options_;
  std::vector<std::vector<std::size_t>> samples_;
  std::vector<Block> blocks_;
  std::size_t folds_ = 0;
  bool cuts_runs_ = false;
  Eigen::Index count_ = 0;
};

}  // namespace torquewright::identification
