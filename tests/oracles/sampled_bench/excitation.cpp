// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/excitation.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::sampled {
namespace {

/// What a course of speed or position may ask for.
struct Limits {
  double value, rate, rate_of_rate;  ///< 0: none.

  double of_sine(double frequency_hz) const {
    const double w = kTwoPi * frequency_hz;
    double most = value;
    if (rate > 0.0) most = std::min(most, rate / w);
    if (rate_of_rate > 0.0) most = std::min(most, rate_of_rate / (w * w));
    return most;
  }
  /// Shortest change by a step: a quintic's greatest slope is 1.875, its curvature 5.8.
  double rise_s(double step) const {
    double least = 0.08;
    if (rate > 0.0) least = std::max(least, 1.9 * std::abs(step) / rate);
    if (rate_of_rate > 0.0) least = std::max(least, std::sqrt(5.8 * std::abs(step) / rate_of_rate));
    return least;
  }
};

Signal stairs(const Limits& limits, double share, double duration_s, double hold_s, Draw& draw) {
  static const std::vector<double> kShares{1.0, 0.7, 0.45, 0.25, 0.1};
  Signal signal;
  double sign = draw.sign();
  double before = 0.0;
  for (double time_s = 0.3; time_s < duration_s;) {
    const double value = sign * share * draw.one_of(kShares) * limits.value;
    const double rise_s = limits.rise_s(value - before);
    signal.levels.push_back({time_s, value, rise_s});
    before = value;
    time_s += rise_s + hold_s * draw.uniform(0.5, 1.5);
    sign = draw.chance(0.75) ? -sign : sign;
  }
  return signal;
}

Signal multisine(const Limits& limits, double share, double most_hz, Draw& draw) {
  Signal signal;
  const int count = draw.between(2, 4);
  for (int k = 0; k < count; ++k) {
    const double frequency_hz = draw.log_uniform(0.12, most_hz);
    const double amplitude =
        share * limits.of_sine(frequency_hz) * draw.uniform(0.7, 1.2) / std::sqrt(count);
    signal.sines.push_back({amplitude, frequency_hz, draw.uniform(0.0, kTwoPi)});
  }
  return signal;
}

Signal chirp(const Limits& limits, double share, double most_hz, double duration_s) {
  Signal signal;
  signal.chirps.push_back({share * limits.of_sine(most_hz), 0.1, most_hz, duration_s});
  return signal;
}

/// A step's period with its harmonics.
Signal gait(const Limits& limits, double share, Draw& draw) {
  Signal signal;
  const double step_hz = draw.uniform(0.5, 1.1);
  for (int k = 1; k <= 3; ++k) {
    const double amplitude = share * limits.of_sine(k * step_hz) * (k == 1 ? 0.7 : 0.25);
    signal.sines.push_back({amplitude, k * step_hz, draw.uniform(0.0, kTwoPi)});
  }
  return signal;
}

Signal course(const Limits& limits, double share, double most_hz, double duration_s, int style,
              Draw& draw) {
  switch (style % 4) {
    case 0:
      return stairs(limits, share, duration_s, 3.0 / (most_hz + 1.0), draw);
    case 1:
      return multisine(limits, share, most_hz, draw);
    case 2:
      return gait(limits, share, draw);
    default:
      return chirp(limits, share, most_hz, duration_s);
  }
}

Limits reference_limits(const Plant& plant) {
  const double inertia = plant.moved_kg_m2();
  const double acceleration = 0.55 * plant.used_torque_Nm / inertia;
  if (plant.load.kind == LoadKind::kPendulum || plant.load.kind == LoadKind::kLinearAxis) {
    return {plant.used_angle_rad, plant.used_speed_rad_s, acceleration};
  }
  return {plant.used_speed_rad_s, acceleration, 0.0};
}

/// The second signal: current at an imposed speed, else the brake's torque.
Limits other_limits(const Plant& plant) {
  const bool imposed = plant.load.kind == LoadKind::kImposedSpeed;
  return {imposed ? plant.used_torque_Nm / plant.Nm_per_A() : 0.5 * plant.used_torque_Nm, 0.0, 0.0};
}

RunPlan rich_run(const Plant& plant, int index, double duration_s, Draw& draw) {
  static const std::vector<double> kShares{1.0, 0.3, 0.6, 1.0, 0.12};
  RunPlan plan;
  plan.duration_s = duration_s;
  plan.is_position =
      plant.load.kind == LoadKind::kPendulum || plant.load.kind == LoadKind::kLinearAxis;
  const double share = kShares[static_cast<std::size_t>(index) % kShares.size()];
  const double most_hz = draw.uniform(1.0, 2.5);
  plan.reference = course(reference_limits(plant), std::max(share, plan.is_position ? 0.3 : 0.0),
                          most_hz, duration_s, index + draw.between(0, 3), draw);
  plan.other = course(other_limits(plant), draw.uniform(0.6, 1.0), 3.0, duration_s,
                      draw.between(0, 3), draw);
  return plan;
}

RunPlan poor_run(const Plant& plant, Richness richness, double duration_s, Draw& draw) {
  RunPlan plan = rich_run(plant, 0, duration_s, draw);
  const Limits speed = reference_limits(plant);
  const Limits other = other_limits(plant);
  if (richness == Richness::kOneSpeed) {
    plan.reference = Signal{.constant = 0.6 * speed.value, .sines = {}, .chirps = {}, .levels = {}};
  } else if (richness == Richness::kOneSine) {
    const double frequency_hz = 0.8;
    plan.reference = Signal{};
    plan.reference.sines.push_back({0.8 * speed.of_sine(frequency_hz), frequency_hz, 0.0});
  }
  plan.other = Signal{.constant = 0.6 * other.value, .sines = {}, .chirps = {}, .levels = {}};
  return plan;
}

}  // namespace

std::vector<RunPlan> draw_runs(const Plant& plant, Richness richness, bool warm, Draw& draw) {
  const int count = draw.chance(0.15) ? draw.between(2, 3) : draw.between(4, 9);
  const double duration_s = draw.uniform(5.0, count > 6 ? 10.0 : 16.0);
  std::vector<RunPlan> plans;
  for (int k = 0; k < count; ++k) {
    const double own_s = duration_s * draw.uniform(0.8, 1.2);
    plans.push_back(richness == Richness::kRich ? rich_run(plant, k, own_s, draw)
                                                : poor_run(plant, richness, own_s, draw));
    // Cold and hot take turns, so that both are in whatever is held out.
    if (warm)
      plans.back().start_winding_K +=
          k % 2 == 0 ? draw.uniform(0.0, 10.0) : draw.uniform(30.0, 60.0);
  }
  if (richness != Richness::kRich) {  // the same again and again
    for (RunPlan& plan : plans) plan.reference = plans.front().reference;
    for (RunPlan& plan : plans) plan.other = plans.front().other;
  }
  return plans;
}

}  // namespace torquewright::oracles::sampled
