// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/rest_mask.hpp"

#include <algorithm>
#include <cmath>

#include "identification/signals/signal.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

constexpr double kAroundRest_s = 0.03;     ///< What a filter of 25 Hz carries out of a rest.
constexpr double kRestShare = 0.005;       ///< Of the speed that 5 % of the samples exceed.
constexpr double kUnknownPosition = 1e-5;  ///< Deviation where no position was logged.
constexpr double kSlowestFilter_Hz = 5.0;  ///< Its settling is cut off at both ends.

/// Slower than this is rest: the position stays within its play for kStandstill_s, or a small share
/// of the log's speeds.
double rest_speed(const std::vector<double>& velocity, double play) {
  std::vector<double> speeds;
  for (const double w : velocity) speeds.push_back(std::abs(w));
  const double high = optimization::lower_quantile(std::move(speeds), 0.95);
  return std::max(play / kStandstill_s, kRestShare * high);
}

void mask_rests(const std::vector<double>& velocity, double slow, double step_s,
                double longer_than_s, std::vector<std::uint8_t>& mask) {
  const std::size_t n = velocity.size();
  const auto span = static_cast<std::size_t>(std::ceil(longer_than_s / step_s));
  const auto around = static_cast<std::size_t>(std::ceil(kAroundRest_s / step_s));
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    if (i < n && std::abs(velocity[i]) < slow) continue;
    if (i - begin >= span) {
      const std::size_t from = begin > around ? begin - around : 0;
      const std::size_t until = std::min(n, i + around);
      for (std::size_t k = from; k < until; ++k) mask[k] = 1;
    }
    begin = i + 1;
  }
}

}  // namespace

double position_play(const Bench& bench, const NoiseLevels& levels) {
  const double ratio = std::abs(bench.actuator().transmission.ratio);
  const auto level = [&](Quantity quantity) { return levels[static_cast<std::size_t>(quantity)]; };
  double deviation = level(bench.is_linear ? Quantity::kLinearPosition : Quantity::kOutputPosition);
  if (deviation == 0.0) deviation = level(Quantity::kMotorPosition) / ratio;
  if (deviation == 0.0) deviation = kUnknownPosition;
  return kPlayDeviations * deviation;
}

double speed_deviation(const Bench& bench, const NoiseLevels& levels) {
  const auto level = [&](Quantity quantity) { return levels[static_cast<std::size_t>(quantity)]; };
  if (bench.encoders == Encoders::kMotor) {
    return level(Quantity::kMotorVelocity) / std::abs(bench.actuator().transmission.ratio);
  }
  return level(bench.is_linear ? Quantity::kLinearVelocity : Quantity::kOutputVelocity);
}

std::vector<std::uint8_t> rest_mask(const std::vector<double>& velocity_rad_s, double play_rad,
                                    double step_s, double longer_than_s) {
  const std::size_t n = velocity_rad_s.size();
  std::vector<std::uint8_t> mask(n, 0);
  mask_rests(velocity_rad_s, rest_speed(velocity_rad_s, play_rad), step_s, longer_than_s, mask);
  const std::size_t edge = LowPass(kSlowestFilter_Hz, 1.0 / step_s).settling();
  for (std::size_t i = 0; i < std::min(edge, n); ++i) mask[i] = mask[n - 1 - i] = 1;
  return mask;
}

}  // namespace torquewright::identification
