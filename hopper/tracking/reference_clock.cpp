// SPDX-License-Identifier: Apache-2.0
#include "hopper/tracking/reference_clock.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/position_step.hpp"

namespace torquewright::hopper {

ReferenceClock::ReferenceClock(const Reference& reference, const ClockOptions& options)
    : reference_(&reference), options_(options) {}

void ReferenceClock::start() {
  mode_ = 0;
  behind_s_ = 0.0;
}

/// Whether one of the points touches that begin to with the mode.
bool ReferenceClock::lands(std::size_t mode, const TouchingPoints& touches) const {
  const TouchingPoints& before = reference_->modes()[mode - 1].touches;
  return (reference_->modes()[mode].touches && !before && touches).any();
}

ClockReading ReferenceClock::read(double time_s, const TouchingPoints& touches) {
  const auto& modes = reference_->modes();
  while (mode_ + 1 < modes.size()) {
    const ContactMode& next = modes[mode_ + 1];
    const double now_s = time_s - behind_s_;
    const bool is_landing = options_.resynchronise && next.begins_with_impact;
    if (is_landing && lands(mode_ + 1, touches) && now_s >= next.from_s - options_.earliest_s) {
      behind_s_ = time_s - next.from_s;
      ++mode_;
      continue;
    }
    const double late_s = now_s - next.from_s;
    if (late_s < 0.0) break;
    if (is_landing && late_s <= options_.longest_wait_s) {
      return {std::nextafter(next.from_s, modes[mode_].from_s), late_s};
    }
    if (is_landing) behind_s_ = time_s - next.from_s;  // what was waited is not made up for
    ++mode_;
  }
  return {time_s - behind_s_, 0.0};
}

void instant_at(const Reference& reference, const dynamics::Tree& tree, const ClockReading& reading,
                ReferenceInstant& out) {
  reference.at(reading.time_s, out);
  if (reading.waited_s == 0.0) return;
  const Eigen::VectorXd mean = out.velocity + 0.5 * reading.waited_s * out.acceleration;
  dynamics::step_position(tree, Eigen::VectorXd(out.position), mean, reading.waited_s,
                          out.position);
  out.velocity += reading.waited_s * out.acceleration;
}

Eigen::VectorXd fed_forward_Nm(const Reference& reference, const ClockReading& reading,
                               double latency_s, double hold_s) {
  double from_s = reading.time_s + latency_s;
  double until_s = from_s + hold_s;
  const std::vector<ContactMode>& modes = reference.modes();
  const std::size_t next = reference.mode_at(reading.time_s) + 1;
  if (next < modes.size() && modes[next].begins_with_impact) {
    const double last_s = std::max(reading.time_s, std::nextafter(modes[next].from_s, 0.0));
    from_s = std::min(from_s, last_s);
    until_s = std::min(until_s, last_s);
  }
  return reference.mean_drive_Nm(from_s, until_s);
}

}  // namespace torquewright::hopper
