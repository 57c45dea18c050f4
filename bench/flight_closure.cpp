// SPDX-License-Identifier: Apache-2.0
#include "bench/flight_closure.hpp"

#include <Eigen/Dense>

#include "dynamics/point.hpp"

namespace torquewright::bench {
namespace {

/// How far the sole is from flat and from the ground at the end of the flight.
Eigen::Vector2d miss(FlipMaker& maker, const std::vector<int>& steps, const FlipNumbers& numbers) {
  const std::vector<FlipSample> samples = maker.motion(numbers, steps);
  FlipSample last;
  for (const FlipSample& sample : samples) {
    if (sample.phase == FlipPhase::kFlight) last = sample;
  }
  maker.state().set(last.position, last.velocity);
  const double height_m = dynamics::point_position_m(maker.state(), {3, {0, 0, -0.08}}).z();
  return {last.position.segment(2, 3).sum() - numbers.turn_rad, height_m};
}

}  // namespace

void close_flight(FlipMaker& maker, const std::vector<int>& steps, FlipNumbers& numbers) {
  constexpr double kChange = 1e-6;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d now = miss(maker, steps, numbers);
    Eigen::Matrix2d slope;
    FlipNumbers other = numbers;
    other.flight_s += kChange;
    slope.col(0) = (miss(maker, steps, other) - now) / kChange;
    other = numbers;
    other.knee_rad.back() += kChange;
    slope.col(1) = (miss(maker, steps, other) - now) / kChange;
    const Eigen::Vector2d step = slope.fullPivLu().solve(now);
    numbers.flight_s -= step[0];
    numbers.knee_rad.back() -= step[1];
  }
}

}  // namespace torquewright::bench
