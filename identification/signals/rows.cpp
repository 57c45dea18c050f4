// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kRowRatePerCutoff = 4.0;  ///< Samples are thinned to this times the cut-off.
constexpr double kRowReach = 0.3;          ///< Periods of the cut-off that the filter smears over.
constexpr double kRowShortestBlock_s = 0.4;
constexpr double kRowBlocksOfShortLog = 48.0;
constexpr double kRowMostBlocks = 400.0;
constexpr std::size_t kRowBlocksOfMap = 4;  ///< Of each of its stretches.
/// Of steady states, which are independent of one another: so many of them make one block.
constexpr std::size_t kRowStatesOfBlock = 6;
constexpr std::size_t kRowLeastFolds = 3;
constexpr std::size_t kRowPieces = 4;  ///< In all, where runs are cut.

/// Samples whose neighbourhood, as far as the filter reaches, is usable.
std::vector<std::size_t> usable_rows_of(const Signals& signals, double cutoff_Hz) {
  const std::size_t n = signals.size();
  std::size_t factor = 1, reach = 0;
  if (signals.step_s > 0.0) {
    const double rate_Hz = 1.0 / signals.step_s;
    factor = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::floor(rate_Hz / (kRowRatePerCutoff * cutoff_Hz))));
    reach = static_cast<std::size_t>(std::round(kRowReach * rate_Hz / cutoff_Hz));
  }
  std::vector<std::size_t> bad_until(n + 1, 0);  // Prefix counts of unusable samples.
  for (std::size_t i = 0; i < n; ++i) bad_until[i + 1] = bad_until[i] + (signals.usable[i] == 0);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < n; i += factor) {
    if (i < signals.core_begin || i >= signals.core_end) continue;
    const std::size_t from = i > reach ? i - reach : 0, until = std::min(n, i + reach + 1);
    if (bad_until[until] == bad_until[from]) rows.push_back(i);
  }
  return rows;
}

double stretch_s(const Signals& stretch) {
  return static_cast<double>(stretch.core_size()) * stretch.step_s;
}

std::size_t blocks_of_map(const Signals& stretch) {
  if (!stretch.is_steady) return kRowBlocksOfMap;
  const auto most = static_cast<std::size_t>(kRowBlocksOfShortLog);
  return std::clamp(stretch.core_size() / kRowStatesOfBlock, kRowBlocksOfMap, most);
}

/// Shorter for a short log, longer for a long one, so that a spread can be estimated.
double row_block_s(const std::vector<Signals>& signals, double usual_s) {
  double total_s = 0.0;
  for (const Signals& stretch : signals) total_s += stretch_s(stretch);
  const double short_s = std::max(kRowShortestBlock_s, total_s / kRowBlocksOfShortLog);
  return std::max(std::min(usual_s, short_s), total_s / kRowMostBlocks);
}

}  // namespace

std::string what_would_help(const std::vector<Signals>& signals) {
  double all = 0.0, masked = 0.0, at_rest = 0.0;
  for (const Signals& stretch : signals) {
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      all += 1.0;
      if (stretch.masked[i] != 0) {
        masked += 1.0;
      } else if (stretch.usable[i] == 0) {
        at_rest += 1.0;
      }
    }
  }
  if (2.0 * masked > all) {
    return fmt::format(
        "{:.0f} % of the samples are masked, so that a drive that stays on and a "
        "recorder without pauses and faults would help",
        100.0 * masked / all);
  }
  if (2.0 * at_rest > all) {
    return fmt::format(
        "in {:.0f} % of the samples the output rests or moves more slowly than the "
        "noise of its position lets see, so that a faster motion, or a velocity or "
        "a position with less noise, would help",
        100.0 * at_rest / all);
  }
  return "a longer log would help";
}

Rows::Rows(const std::vector<Signals>& signals, const std::vector<std::size_t>& fold_of_run,
           const Options& options)
    : signals_(signals), options_(options) {
  const double block_s = row_block_s(signals, options.block_s);
  for (const Signals& stretch : signals) {
    samples_.push_back(usable_rows_of(stretch, options.cutoff_Hz));
    const std::size_t fold = fold_of_run[stretch.run];
    cut(stretch, static_cast<std::size_t>(count_), samples_.back().size(), block_s, fold);
    count_ += static_cast<Eigen::Index>(samples_.back().size());
    if (fold != kHeldOut) folds_ = std::max(folds_, fold + 1);
  }
  if (folds_ < kRowLeastFolds) cut_runs_into_folds();
}

/// Blocks of one stretch: equal times of it; those without a usable row are not there.
void Rows::cut(const Signals& stretch, std::size_t first_row, std::size_t rows, double block_s,
               std::size_t fold) {
  const std::vector<std::size_t>& samples = samples_.back();
  const std::size_t pieces =
      stretch.step_s > 0.0
          ? std::max<std::size_t>(
                1, static_cast<std::size_t>(std::round(stretch_s(stretch) / block_s)))
          : blocks_of_map(stretch);
  const double length = static_cast<double>(stretch.core_size()) / static_cast<double>(pieces);
  std::size_t begin = 0;
  for (std::size_t p = 0; p < pieces && begin < rows; ++p) {
    std::size_t end = begin;
    while (end < rows &&
           (p + 1 == pieces || static_cast<double>(samples[end] - stretch.core_begin) <
                                   static_cast<double>(p + 1) * length)) {
      ++end;
    }
    if (end > begin) {
      blocks_.push_back({static_cast<Eigen::Index>(first_row + begin),
                         static_cast<Eigen::Index>(end - begin), stretch.run, fold});
    }
    begin = end;
  }
}

void Rows::cut_runs_into_folds() {
  cuts_runs_ = true;
  const std::size_t training = training_blocks();
  folds_ = std::min(kRowPieces, std::max<std::size_t>(training, 1));
  std::size_t at = 0;
  for (Block& block : blocks_) {
    if (!block.is_held_out()) block.fold = at++ * folds_ / training;
  }
}

std::size_t Rows::training_blocks() const {
  return static_cast<std::size_t>(std::count_if(
      blocks_.begin(), blocks_.end(), [](const Block& each) { return !each.is_held_out(); }));
}

Eigen::VectorXd Rows::values(const OfStretch& of_stretch, const std::vector<Signals>& like) const {
  Eigen::VectorXd all(count_);
  Eigen::Index row = 0;
  for (std::size_t s = 0; s < like.size(); ++s) {
    if (samples_[s].empty()) continue;
    std::vector<double> values = of_stretch(like[s]);
    if (like[s].step_s > 0.0) LowPass(options_.cutoff_Hz, 1.0 / like[s].step_s).apply(values);
    for (const std::size_t sample : samples_[s]) all[row++] = values[sample];
  }
  return all;
}

}  // namespace torquewright::identification
