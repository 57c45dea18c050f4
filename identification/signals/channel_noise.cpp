// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/channel_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "identification/signals/scatter.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr std::size_t kLeastSamples = 16;
/// A channel of fewer is switched between set values, and their distance is no resolution.
constexpr std::size_t kManyLevels = 16;
constexpr std::size_t kMostLevels = 4096;  ///< That are looked at.
constexpr double kSameGap = 1.1;           ///< Decimals round a step.
/// Equal neighbours, of all samples: white noise never repeats a value, a quantised channel does.
constexpr double kRepeats = 0.05;
constexpr double kHeld = 0.95;  ///< The same of a command that holds its set values.

/// Sensors and drives count in single precision at best.
constexpr double kFinest = std::numeric_limits<float>::epsilon();

double deviation_of_step(double step) { return step / std::sqrt(12.0); }

/// What is asked of one channel, over all runs.
class ChannelNoise {
 public:
  void add(const std::vector<double>& time_s, const std::vector<double>& signal) {
    if (signal.size() < kLeastSamples) return;
    std::size_t equal = 0;
    for (std::size_t i = 0; i < signal.size(); ++i) {
      greatest_ = std::max(greatest_, std::abs(signal[i]));
      if (i > 0 && signal[i] == signal[i - 1]) {
        ++equal;
      } else if (levels_.size() < kMostLevels) {
        levels_.insert(signal[i]);
      }
    }
    const auto samples = static_cast<double>(signal.size());
    const double white = time_s.empty() ? noise_level(signal) : noise_level(time_s, signal);
    parts_.push_back({white, samples, static_cast<double>(equal) > kRepeats * samples});
    samples_ += samples;
    equal_ += static_cast<double>(equal);
  }

  bool is_held() const { return equal_ > kHeld * samples_; }

  /// `printed_step`: of the last digit that its log writes.
  double of_command(double printed_step) const {
    return levels_.size() < kManyLevels ? 0.0 : deviation_of_step(printed_step);
  }

  double of_measurement(double printed_step) const {
    if (samples_ == 0.0) return 0.0;
    const double quantised = deviation_of_step(common_step());
    const double least = std::max(of_command(printed_step), deviation_of_step(kFinest * greatest_));
    double sum = 0.0;
    for (const Part& part : parts_) {
      const double level = std::max({part.white, part.repeats ? quantised : 0.0, least});
      sum += level * level * part.samples;
    }
    return std::sqrt(sum / samples_);
  }

 private:
  /// The smallest distance of neighbouring levels that many have; 0 of a channel that is not
  /// quantised.
  double common_step() const {
    if (levels_.size() < kManyLevels) return 0.0;
    std::vector<double> gaps;
    for (auto at = std::next(levels_.begin()); at != levels_.end(); ++at) {
      gaps.push_back(*at - *std::prev(at));
    }
    std::sort(gaps.begin(), gaps.end());
    const double step = gaps[gaps.size() / 10];
    return gaps[gaps.size() / 3] <= kSameGap * step ? step : 0.0;
  }

  struct Part {
    double white = 0.0, samples = 0.0;
    bool repeats = false;
  };
  std::vector<Part> parts_;
  std::set<double> levels_;
  double samples_ = 0.0, equal_ = 0.0, greatest_ = 0.0;
};

double level_of(const ChannelNoise& channel, Quantity quantity, double printed_step) {
  if (quantity == Quantity::kTime || quantity == Quantity::kRun) return 0.0;
  const bool is_set = quantity == Quantity::kWindingVoltage && channel.is_held();
  return is_command(quantity) || is_set ? channel.of_command(printed_step)
                                        : channel.of_measurement(printed_step);
}

}  // namespace

NoiseLevels noise_levels(const Log& log, std::size_t joint) {
  std::array<ChannelNoise, kQuantityCount> channels;
  for (const Run& run : log.runs) {
    for (std::size_t q = 0; q < kQuantityCount; ++q)
      channels[q].add(run.time_s, run.joints[joint].of[q]);
  }
  const PrintedSteps printed = joint < log.printed.size() ? log.printed[joint] : PrintedSteps{};
  NoiseLevels levels{};
  for (std::size_t q = 0; q < kQuantityCount; ++q) {
    levels[q] = level_of(channels[q], static_cast<Quantity>(q), printed[q]);
  }
  return levels;
}

NoiseLevels noise_of_states(const Log& log, std::size_t joint) {
  NoiseLevels levels{};
  const PrintedSteps printed = joint < log.printed.size() ? log.printed[joint] : PrintedSteps{};
  for (std::size_t q = 0; q < kQuantityCount; ++q) levels[q] = deviation_of_step(printed[q]);
  const Scatter scatter(log, joint);
  for (const Quantity each : scatter.dependent()) {
    double& level = levels[static_cast<std::size_t>(each)];
    level = std::max(level, scatter.level(each));
  }
  return levels;
}

}  // namespace torquewright::identification
