// SPDX-License-Identifier: Apache-2.0
#include "identification/signals/thinning.hpp"

#include <algorithm>

namespace torquewright::identification {
namespace {

template <typename T>
void thin_values(std::vector<T>& values, std::size_t factor) {
  if (values.empty() || factor <= 1) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); i += factor) values[kept++] = values[i];
  values.resize(kept);
}

/// A reversal between two samples that stay must count at its time: a direction is the mean over
/// what its sample stands for, half of the samples at the ends.
void average_directions(std::vector<actuator::Instant>& at, std::size_t factor) {
  if (factor <= 1) return;
  std::vector<double> sum(at.size() + 1, 0.0);  // Of what stands before each sample.
  for (std::size_t i = 0; i < at.size(); ++i) sum[i + 1] = sum[i] + at[i].direction;
  const std::size_t half = factor / 2;
  const double end = factor % 2 == 0 ? 0.5 : 0.0;  // Weight that the outermost two lose.
  for (std::size_t i = half; i + half < at.size(); i += 1) {
    const double whole = sum[i + half + 1] - sum[i - half];
    const double outer = sum[i - half + 1] - sum[i - half] + sum[i + half + 1] - sum[i + half];
    at[i].direction = std::clamp((whole - end * outer) / static_cast<double>(factor), -1.0, 1.0);
  }
}

}  // namespace

void thin(Signals& signals, std::size_t factor) {
  for (std::vector<double>* values :
       {&signals.time_s, &signals.filtered_direction, &signals.motor_side_Nm, &signals.load_side_Nm,
        &signals.filtered_current_sign, &signals.current_rate_A_s, &signals.voltage_V,
        &signals.bus_V, &signals.bus_A, &signals.logged_velocity_rad_s,
        &signals.motor_velocity_rad_s, &signals.motor_acceleration_rad_s2, &signals.twist_rad}) {
    thin_values(*values, factor);
  }
  for (JointMotion& motion : signals.arm) {
    thin_values(motion.position_rad, factor);
    thin_values(motion.velocity_rad_s, factor);
    thin_values(motion.acceleration_rad_s2, factor);
  }
  average_directions(signals.at, factor);
  thin_values(signals.at, factor);
  thin_values(signals.masked, factor);
  thin_values(signals.usable, factor);
  signals.raw_per_sample *= factor;
  signals.step_s *= static_cast<double>(factor);
}

}  // namespace torquewright::identification
