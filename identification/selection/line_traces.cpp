// SPDX-License-Identifier: Apache-2.0
#include "identification/selection/line_traces.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::identification {
namespace {

/// Of the motion and of the drive, in the band of filtered signals.
double motion_Hz(const Signals& signals) {
  std::vector<double> speed, current;
  for (const actuator::Instant& at : signals.at) {
    speed.push_back(at.speed_rad_s);
    current.push_back(at.current_A);
  }
  return std::max(edge_Hz(speed, signals.step_s), edge_Hz(current, signals.step_s));
}

}  // namespace

std::vector<LineTrace> line_traces(const ForwardEquation& equation, const Hypothesis& hypothesis,
                                   const HeldSignals& held) {
  std::vector<LineTrace> traces;
  for (const Signals& filtered : held.rows) {
    const auto signals = held.unfiltered ? held.unfiltered(filtered.run) : std::nullopt;
    if (!signals) continue;
    const std::vector<double> left = equation.residual(hypothesis, *signals);
    LineTrace trace;
    trace.run = signals->run_name;
    trace.step_s = signals->step_s;
    trace.motion_Hz = motion_Hz(filtered);
    const std::size_t end = signals->core_begin + signals->core_size();
    for (std::size_t i = signals->core_begin; i < end; ++i) {
      trace.usable.push_back(signals->usable[i] != 0 && std::isfinite(left[i]));
      trace.value.push_back(
          trace.usable.back() != 0 ? std::abs(equation.unit_per_residual) * left[i] : 0.0);
      trace.motor_rad.push_back(signals->at[i].motor_angle_rad);
    }
    traces.push_back(std::move(trace));
  }
  return traces;
}

}  // namespace torquewright::identification
