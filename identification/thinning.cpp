// SPDX-License-Identifier: Apache-2.0
#include "identification/thinning.hpp"

namespace torquewright::identification {
namespace {

template <typename T>
void thin_values(std::vector<T>& values, std::size_t factor) {
  if (values.empty() || factor <= 1) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); i += factor) values[kept++] = values[i];
  values.resize(kept);
}

}  // namespace

void thin(Signals& signals, std::size_t factor) {
  for (std::vector<double>* values :
       {&signals.time_s, &signals.motor_side_Nm, &signals.load_side_Nm, &signals.voltage_V,
        &signals.bus_V, &signals.bus_A, &signals.logged_velocity_rad_s,
        &signals.motor_velocity_rad_s, &signals.twist_rad}) {
    thin_values(*values, factor);
  }
  for (JointMotion& motion : signals.arm) {
    thin_values(motion.position_rad, factor);
    thin_values(motion.velocity_rad_s, factor);
    thin_values(motion.acceleration_rad_s2, factor);
  }
  thin_values(signals.at, factor);
  thin_values(signals.masked, factor);
  thin_values(signals.usable, factor);
  signals.step_s *= static_cast<double>(factor);
}

}  // namespace torquewright::identification
