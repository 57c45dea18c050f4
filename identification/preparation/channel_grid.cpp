// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/channel_grid.hpp"

#include <algorithm>
#include <cmath>

#include "identification/log/stretch.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kRoundOff = 1e-9;  ///< Of a step.

/// Rows that would stand in the gaps, were there none.
std::size_t missing_rows(const std::vector<double>& time_s, double usual_s) {
  std::size_t missing = 0;
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double steps = (time_s[i] - time_s[i - 1]) / usual_s;
    if (steps > kGapFactor) missing += static_cast<std::size_t>(std::round(steps)) - 1;
  }
  return missing;
}

}  // namespace

ChannelGrid::ChannelGrid(const Run& run, std::size_t joint, const PreparationOptions& options,
                         std::mt19937_64& random)
    : run_(run),
      channels_(run.joints[joint]),
      options_(options),
      random_(random),
      is_map_(run.time_s.empty()),
      count_(run.masked.size()),
      masked_(run.masked) {
  if (is_map_) return;
  start_s_ = run.time_s.front();
  const double usual_s = median_step_s(run.time_s);
  const std::size_t missing = missing_rows(run.time_s, usual_s);
  is_bridged_ = missing > 0;
  count_ += missing;
  step_s_ = (run.time_s.back() - start_s_) / static_cast<double>(count_ - 1);
  if (is_bridged_) masked_ = masked_with_gaps(usual_s);
}

std::size_t ChannelGrid::sample_of(std::size_t row) const {
  if (!is_bridged_) return row;
  if (row >= run_.masked.size()) return count_;
  const double samples = (run_.time_s[row] - start_s_) / step_s_;
  return std::min(count_, static_cast<std::size_t>(std::ceil(samples - kRoundOff)));
}

/// A sample is masked with the nearer row; within a gap, always.
std::vector<std::uint8_t> ChannelGrid::masked_with_gaps(double usual_s) const {
  const std::vector<double>& time_s = run_.time_s;
  std::vector<std::uint8_t> masked(count_, 0);
  std::size_t at = 0;
  for (std::size_t k = 0; k < count_; ++k) {
    const double t_s = start_s_ + static_cast<double>(k) * step_s_;
    while (at + 2 < time_s.size() && time_s[at + 1] < t_s) ++at;
    const bool is_gap = time_s[at + 1] - time_s[at] > kGapFactor * usual_s;
    const double share = (t_s - time_s[at]) / (time_s[at + 1] - time_s[at]);
    const bool is_row = share < kRoundOff || share > 1.0 - kRoundOff;
    masked[k] = (is_gap && !is_row) || run_.masked[share < 0.5 ? at : at + 1] != 0;
  }
  return masked;
}

std::vector<double> ChannelGrid::read(Quantity quantity) {
  return filtered(read_unfiltered(quantity));
}

std::vector<double> ChannelGrid::filtered(std::vector<double> values) const {
  if (!is_map_) LowPass(options_.cutoff_Hz, 1.0 / step_s_).apply(values);
  return values;
}

std::vector<double> ChannelGrid::read_unfiltered(Quantity quantity) {
  std::vector<double> raw = channels_[quantity];
  const auto index = static_cast<std::size_t>(quantity);
  if (options_.noise != nullptr && (*options_.noise)[index] > 0.0) {
    std::normal_distribution<double> noise(0.0, (*options_.noise)[index]);
    for (double& value : raw) value += noise(random_);
  }
  if (is_map_) return raw;
  // What is set jumps: a cubic would overshoot.
  const bool jumps = is_command(quantity) || quantity == Quantity::kWindingVoltage;
  return (jumps ? resampled_linearly : resampled)(run_.time_s, raw, start_s_, step_s_, count_);
}

std::vector<double> ChannelGrid::read_or(Quantity quantity, double otherwise) {
  return has(quantity) ? read(quantity) : std::vector<double>(count_, otherwise);
}

std::vector<double> ChannelGrid::read_if_any(Quantity quantity) {
  return has(quantity) ? read(quantity) : std::vector<double>();
}

}  // namespace torquewright::identification
