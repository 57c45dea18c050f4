// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/channel_grid.hpp"

#include "identification/signals/signal.hpp"

namespace torquewright::identification {

ChannelGrid::ChannelGrid(const Run& run, std::size_t joint, const PreparationOptions& options,
                         std::mt19937_64& random)
    : run_(run),
      channels_(run.joints[joint]),
      options_(options),
      random_(random),
      is_map_(run.time_s.empty()),
      count_(run.masked.size()) {
  if (is_map_) return;
  start_s_ = run.time_s.front();
  step_s_ = (run.time_s.back() - start_s_) / static_cast<double>(count_ - 1);
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
  return resampled(run_.time_s, raw, start_s_, step_s_, count_);
}

std::vector<double> ChannelGrid::read_or(Quantity quantity, double otherwise) {
  return has(quantity) ? read(quantity) : std::vector<double>(count_, otherwise);
}

std::vector<double> ChannelGrid::read_if_any(Quantity quantity) {
  return has(quantity) ? read(quantity) : std::vector<double>();
}

}  // namespace torquewright::identification
