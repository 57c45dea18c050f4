// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/motions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace torquewright::oracles::robot_bench {
namespace {

using mujoco_bench::Draws;
using Target = std::function<double(double)>;

constexpr double kTurn_rad = 2 * std::numbers::pi;
/// Waves and sweeps rise from nothing in this time.
constexpr double kFade_s = 0.5;

Target waves(Draws& draws, double amplitude_rad, double top_hz) {
  struct Wave {
    double share, hz, phase_rad;
  };
  std::vector<Wave> all;
  for (int k = 0; k < 4; ++k)
    all.push_back(
        {draws.uniform(0.2, 1), draws.log_uniform(0.08, top_hz), draws.uniform(0, kTurn_rad)});
  double sum = 0;
  for (const Wave& one : all) sum += one.share;
  return [=](double t) {
    double at = 0;
    for (const Wave& one : all)
      at += one.share / sum * std::sin(kTurn_rad * one.hz * t + one.phase_rad);
    return 1.4 * amplitude_rad * at * std::min(1.0, t / kFade_s);
  };
}

Target sweep(Draws& draws, double amplitude_rad, double top_hz, double duration_s) {
  const double low_hz = 0.15, rate = std::log(top_hz / low_hz) / duration_s;
  const double sign = draws.sign();
  return [=](double t) {
    const double angle = kTurn_rad * low_hz * (std::exp(rate * t) - 1) / rate;
    const double smaller = std::sqrt(low_hz / (low_hz * std::exp(rate * t)));
    return sign * amplitude_rad * std::max(0.35, smaller) * std::sin(angle);
  };
}

/// Straight lines of `line_s`, each followed by a rest.
Target lines(Draws& draws, double amplitude_rad, double line_s, double rest_s, double duration_s) {
  std::vector<double> points;
  for (double t = 0; t < duration_s + line_s; t += line_s + rest_s)
    points.push_back(points.empty() ? 0 : draws.uniform(-amplitude_rad, amplitude_rad));
  points.push_back(points.back());
  return [=](double t) {
    const double place = t / (line_s + rest_s);
    const auto k = std::min(static_cast<std::size_t>(place), points.size() - 2);
    const double share =
        std::min(1.0, (place - static_cast<double>(k)) * (line_s + rest_s) / line_s);
    return points[k] + share * (points[k + 1] - points[k]);
  };
}

Target draw_target(Draws& draws, double amplitude_rad, double speed, double duration_s) {
  const double top_hz = 0.4 + 2.2 * speed;
  switch (draws.below(4)) {
    case 0:
    case 1:
      return waves(draws, amplitude_rad, top_hz);
    case 2:
      return sweep(draws, 0.6 * amplitude_rad, top_hz, duration_s);
    default:
      return lines(draws, amplitude_rad, 1.5 - 1.1 * speed, draws.chance(0.5) ? 0.3 : 0,
                   duration_s);
  }
}

}  // namespace

Commands draw_motion(Draws& draws, const Robot& robot, double duration_s, double packet_s,
                     double speed) {
  Commands commands;
  commands.packet_s = packet_s;
  const auto packets = static_cast<std::size_t>(std::lround(duration_s / packet_s));
  for (const std::string& name : robot.moved()) {
    const Joint& joint = robot.joint(name);
    const double middle = std::clamp(joint.middle_rad(), -1.8, 1.8);
    const double room = std::min(joint.high_rad - middle, middle - joint.low_rad);
    const double amplitude = std::min(0.85 * room, draws.uniform(0.3, 0.7));
    const Target target = draw_target(draws, amplitude, speed, duration_s);
    std::vector<double> targets;
    for (std::size_t k = 0; k < packets; ++k)
      targets.push_back(middle + target(static_cast<double>(k) * packet_s));
    commands.targets_rad.push_back(targets);
  }
  return commands;
}

}  // namespace torquewright::oracles::robot_bench
