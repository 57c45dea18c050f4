// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/loop_bench/motion.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::loop {
namespace {

constexpr double kCurrentLoop_s = 3e-4;
constexpr int kSweeps = 12;

/// From 0 to 1 with rest at both ends.
double eased(double part) {
  const double p = std::clamp(part, 0.0, 1.0);
  return p * p * p * (10.0 + p * (-15.0 + 6.0 * p));
}

double commanded_A(const Drive& drive, const Loop& loop, std::size_t joint, double asked_rad,
                   double asked_rad_s, const State& at) {
  const double torque_Nm = loop.stiffness_Nm_rad[joint] * (asked_rad - at.position_rad[joint]) +
                           loop.damping_Nm_s_rad[joint] * (asked_rad_s - at.speed_rad_s[joint]);
  return std::clamp(torque_Nm / drive.torque_per_current_Nm_A(), -drive.peak_current_A,
                    drive.peak_current_A);
}

/// Speeds after impulses of dry friction, each within its bounds, that leave least sliding.
Pair rubbed(const std::array<Pair, 2>& inverse, Pair speed, const std::array<DryFriction, 2>& dry,
            std::size_t joints) {
  Pair impulse{};
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t j = 0; j < joints; ++j) {
      const double before = impulse[j];
      impulse[j] = std::clamp(before - speed[j] / inverse[j][j], -dry[j].forwards_Nm * kStep_s,
                              dry[j].backwards_Nm * kStep_s);
      for (std::size_t k = 0; k < joints; ++k) speed[k] += inverse[k][j] * (impulse[j] - before);
    }
  }
  return speed;
}

/// The inverse of mass matrix and rotors.
std::array<Pair, 2> inverse_of(const LinkTorques& links, const Pair& rotors, std::size_t joints) {
  const double a = links.m11 + rotors[0];
  if (joints < 2) return {{{1.0 / a, 0.0}, {0.0, 1.0}}};
  const double b = links.m12, d = links.m22 + rotors[1];
  const double det = a * d - b * b;
  return {{{d / det, -b / det}, {-b / det, a / det}}};
}

void step(const Rig& rig, const std::vector<std::vector<Law>>& laws, double time_s, State& s) {
  const LinkTorques links = link_torques(rig, s.position_rad, s.speed_rad_s);
  Pair push{}, rotors{};
  std::array<DryFriction, 2> dry{};
  for (std::size_t j = 0; j < rig.joints(); ++j) {
    const Drive& drive = rig.drives[j];
    const Moment at{time_s, s.position_rad[j], s.speed_rad_s[j], s.load_Nm[j]};
    rotors[j] = drive.reflected_inertia_kg_m2();
    dry[j] = dry_friction(laws[j], at);
    push[j] = drive.torque_per_current_Nm_A() * effective_current_A(laws[j], s.torque_A[j]) +
              smooth_torque_Nm(laws[j], at, drive.ratio) - links.bias_Nm[j];
  }
  const auto inverse = inverse_of(links, rotors, rig.joints());
  Pair speed = s.speed_rad_s;
  for (std::size_t j = 0; j < rig.joints(); ++j)
    for (std::size_t k = 0; k < rig.joints(); ++k) speed[j] += kStep_s * inverse[j][k] * push[k];
  speed = rubbed(inverse, speed, dry, rig.joints());
  for (std::size_t j = 0; j < rig.joints(); ++j) {
    s.acceleration_rad_s2[j] = (speed[j] - s.speed_rad_s[j]) / kStep_s;
    s.position_rad[j] += kStep_s * speed[j];
  }
  const Pair& a = s.acceleration_rad_s2;
  s.load_Nm = {links.m11 * a[0] + links.m12 * a[1] + links.bias_Nm[0],
               links.m12 * a[0] + links.m22 * a[1] + links.bias_Nm[1]};
  s.speed_rad_s = speed;
}

}  // namespace

double Reference::at(double time_s) const {
  double sum = middle_rad + turning_rad_s * time_s;
  for (const Wave& wave : waves)
    sum += wave.amplitude_rad * std::sin(wave.rate_rad_s * time_s + wave.phase_rad);
  const double part = std::fmod(time_s / ramp_period_s, 1.0) * 4.0;
  return sum + ramp_rad * (eased(part) - eased(part - 2.0));
}

std::vector<State> moved(const Rig& rig, const Loop& loop, const Run& run) {
  std::vector<std::vector<Law>> laws;
  for (const Drive& drive : rig.drives) laws.push_back(drive.laws());
  const auto steps = static_cast<std::size_t>(run.duration_s / kStep_s);
  const auto each = static_cast<std::size_t>(std::llround(loop.period_s / kStep_s));
  State now;
  for (std::size_t j = 0; j < rig.joints(); ++j) now.position_rad[j] = run.references[j].at(0.0);
  Pair asked_A{};
  std::vector<State> states;
  states.reserve(steps);
  for (std::size_t k = 0; k < steps; ++k) {
    const double time_s = static_cast<double>(k) * kStep_s;
    for (std::size_t j = 0; j < rig.joints(); ++j) {
      const Reference& asked = run.references[j];
      if (k % each == 0) {
        const double rate = (asked.at(time_s + 1e-4) - asked.at(time_s - 1e-4)) / 2e-4;
        asked_A[j] = commanded_A(rig.drives[j], loop, j, asked.at(time_s), rate, now);
      }
      now.current_A[j] += kStep_s / kCurrentLoop_s * (asked_A[j] - now.current_A[j]);
      const Law* lag = law_named(laws[j], "torque_lag");
      const double part = lag == nullptr ? 1.0 : kStep_s / lag->at("time_constant_s");
      now.torque_A[j] += std::min(part, 1.0) * (now.current_A[j] - now.torque_A[j]);
    }
    step(rig, laws, time_s, now);
    states.push_back(now);
  }
  return states;
}

}  // namespace torquewright::oracles::loop
