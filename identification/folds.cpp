// SPDX-License-Identifier: Apache-2.0
#include "identification/folds.hpp"

#include <algorithm>

#include "identification/log/run_groups.hpp"
#include "identification/model.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastFolds = 3;
constexpr std::size_t kPieces = 4;  ///< In all, where runs are cut.

}  // namespace

std::vector<std::size_t> run_folds(const Log& log) {
  std::vector<std::size_t> folds;
  for (const RunGroup& group : run_groups(log)) {
    folds.push_back(group.is_held_out ? Fitter::kNoFold : group.number);
  }
  return folds;
}

Folds make_folds(const Log& log, const Gram& gram) { return folds_of_blocks(run_folds(log), gram); }

Folds folds_of_blocks(std::vector<std::size_t> of_run, const Gram& gram) {
  Folds folds;
  folds.of_run = std::move(of_run);
  std::size_t count = 0;
  for (const std::size_t fold : folds.of_run) {
    if (fold != Fitter::kNoFold) count = std::max(count, fold + 1);
  }
  for (const Block& block : gram.blocks) folds.of_block.push_back(folds.of_run[block.run]);
  if (count >= kLeastFolds) return folds;
  folds.cut_runs = true;
  std::size_t training = 0;
  for (const std::size_t fold : folds.of_block) training += fold != Fitter::kNoFold;
  const std::size_t pieces = std::min(kPieces, std::max<std::size_t>(training, 1));
  std::size_t at = 0;
  for (std::size_t& fold : folds.of_block) {
    if (fold != Fitter::kNoFold) fold = at++ * pieces / training;
  }
  return folds;
}

}  // namespace torquewright::identification
