// SPDX-License-Identifier: Apache-2.0
#include "identification/experiment/excitation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace torquewright::identification {
namespace {

constexpr std::size_t kPerRun = 10;
constexpr double kRamp_s = 0.4;  ///< A run begins and ends at rest.
constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kChirpFrom_Hz = 0.1;
constexpr double kChirpTo_Hz = 5.0;

/// From 1 at whole numbers by straight lines to -1 between them, a quarter late: starts at 0.
double triangle(double turns) {
  const double phase = turns + 0.75 - std::floor(turns + 0.75);
  return 4.0 * std::abs(phase - 0.5) - 1.0;
}

double smooth_step(double x) {
  const double s = std::clamp(x, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

double ramp(double time_s, double length_s) {
  return smooth_step(time_s / kRamp_s) * smooth_step((length_s - time_s) / kRamp_s);
}

double linear_share(double share, double from, double to) { return from + share * (to - from); }
double log_share(double share, double from, double to) { return from * std::pow(to / from, share); }

std::size_t samples_of(const ExcitationFrame& frame) {
  const double length_s = frame.duration_s / static_cast<double>(frame.runs.size());
  return static_cast<std::size_t>(std::floor(length_s / frame.step_s)) + 1;
}

using OfTime = std::function<double(double)>;

/// Speed first, so that the current can follow what the region allows at it.
ExcitationRun imposed_run(const ExcitationLimits& limits, const ExcitationFrame& frame,
                          const std::string& name, const OfTime& speed, const OfTime& part) {
  ExcitationRun run;
  run.name = name;
  simulation::JointDrive& joint = run.excitation.joints.emplace_back();
  for (std::size_t i = 0; i < samples_of(frame); ++i) {
    const double time_s = static_cast<double>(i) * frame.step_s;
    run.excitation.time_s.push_back(time_s);
    joint.speed_rad_s.push_back(speed(time_s));
    const double share = std::clamp(part(time_s), -1.0, 1.0);
    joint.value.push_back(share * limits.current_A(joint.speed_rad_s.back(), share));
  }
  return run;
}

ExcitationRun driven_run(const ExcitationFrame& frame, const std::string& name,
                         const OfTime& current_A) {
  ExcitationRun run;
  run.name = name;
  simulation::JointDrive& joint = run.excitation.joints.emplace_back();
  for (std::size_t i = 0; i < samples_of(frame); ++i) {
    const double time_s = static_cast<double>(i) * frame.step_s;
    run.excitation.time_s.push_back(time_s);
    joint.value.push_back(current_A(time_s));
  }
  return run;
}

/// Levels of both signs, large and small, driving and back-driving at each.
double staircase(double steps, std::size_t first) {
  constexpr std::array<double, 8> kLevels = {1.0, -0.3, 0.6, -1.0, 0.0, 0.3, -0.6, 0.0};
  constexpr double kEdge = 0.05;  // Of a step: no jump, which no driver follows.
  const auto count = static_cast<std::size_t>(std::floor(steps));
  const double now = kLevels[(count + first) % kLevels.size()];
  const double before = count == 0 ? 0.0 : kLevels[(count + first - 1) % kLevels.size()];
  return before + (now - before) * smooth_step((steps - static_cast<double>(count)) / kEdge);
}

ExcitationRun imposed_mix(const ExcitationLimits& limits, const ExcitationFrame& frame,
                          std::size_t number, std::span<const double> mix, double scale) {
  const double length_s = frame.duration_s / static_cast<double>(frame.runs.size());
  const double triangle_Hz = log_share(mix[3], 0.2, 0.9);
  const double sine_Hz = linear_share(mix[5], 1.0, 5.0);
  const double fast_rad_s =
      scale * linear_share(mix[0], 0.5, 1.0) * limits.speed_at(triangle_Hz) / 1.3;
  const double slow_share = log_share(mix[1], 0.02, 0.3);
  const double slow_until_s = linear_share(mix[2], 0.2, 0.6) * length_s;
  const double sine_share = linear_share(mix[4], 0.0, 0.3);
  const double stair_s = log_share(mix[6], 0.3, 1.5);
  const double current_sine = linear_share(mix[7], 0.0, 0.4);
  const double current_Hz = linear_share(mix[8], 0.3, 4.0);
  const double current = linear_share(mix[9], 0.6, 1.0);
  const auto speed = [=](double t) {
    const double share =
        slow_share + (1.0 - slow_share) * smooth_step((t - slow_until_s) / kRamp_s);
    return fast_rad_s * share * ramp(t, length_s) *
           (triangle(triangle_Hz * t) + sine_share * std::sin(kTurn * sine_Hz * t));
  };
  const auto part = [=](double t) {
    return ramp(t, length_s) * current *
           (staircase(t / stair_s, 3 * number) * (1.0 - current_sine) +
            current_sine * std::sin(kTurn * current_Hz * t));
  };
  return imposed_run(limits, frame, frame.runs[number], speed, part);
}

/// Cosines of current, so that a free load's speed has no mean.
ExcitationRun driven_mix(const ExcitationLimits& limits, const ExcitationFrame& frame,
                         std::size_t number, std::span<const double> mix, double scale) {
  const double length_s = frame.duration_s / static_cast<double>(frame.runs.size());
  const std::array<double, 3> frequency_Hz = {
      log_share(mix[0], 0.1, 0.5), log_share(mix[2], 0.5, 2.0), log_share(mix[4], 2.0, 7.0)};
  const std::array<double, 3> share = {linear_share(mix[1], 0.1, 0.6),
                                       linear_share(mix[3], 0.1, 0.6),
                                       linear_share(mix[5], 0.1, 0.6)};
  std::array<double, 3> current_A{};
  const double most_A = limits.current_A(0.0, 1.0);
  for (std::size_t k = 0; k < current_A.size(); ++k) {
    const double speed = share[k] * limits.speed_at(frequency_Hz[k]);
    current_A[k] =
        scale * std::min(limits.current_for_A(speed, frequency_Hz[k]), share[k] * most_A);
    if ((number + k) % 2 == 1) current_A[k] = -current_A[k];
  }
  const double pause_from_s = linear_share(mix[6], 0.6, 1.0) * length_s;
  return driven_run(frame, frame.runs[number], [=](double t) {
    double sum_A = 0.0;
    for (std::size_t k = 0; k < current_A.size(); ++k) {
      sum_A += current_A[k] * std::cos(kTurn * frequency_Hz[k] * t);
    }
    return sum_A * smooth_step((pause_from_s - t) / kRamp_s + 1.0);
  });
}

}  // namespace

std::size_t mix_parameters(const ExcitationFrame& frame) { return kPerRun * frame.runs.size(); }

std::vector<ExcitationRun> mixed_excitation(const ExcitationLimits& limits,
                                            const ExcitationFrame& frame,
                                            std::span<const double> mix, double scale) {
  std::vector<ExcitationRun> runs;
  for (std::size_t r = 0; r < frame.runs.size(); ++r) {
    const auto own = mix.subspan(kPerRun * r, kPerRun);
    runs.push_back(limits.is_imposed() ? imposed_mix(limits, frame, r, own, scale)
                                       : driven_mix(limits, frame, r, own, scale));
  }
  return runs;
}

std::vector<ExcitationRun> chirp_excitation(const ExcitationLimits& limits,
                                            const ExcitationFrame& frame, double scale) {
  const double length_s = frame.duration_s / static_cast<double>(frame.runs.size());
  const double rate = std::log(kChirpTo_Hz / kChirpFrom_Hz) / length_s;
  const auto turns = [=](double t) { return kChirpFrom_Hz * std::expm1(rate * t) / rate; };
  std::vector<ExcitationRun> runs;
  for (const std::string& name : frame.runs) {
    if (limits.is_imposed()) {
      const auto speed = [&](double t) {
        return scale * limits.speed_at(kChirpFrom_Hz) * ramp(t, length_s) *
               std::sin(kTurn * turns(t));
      };
      const auto part = [&](double t) {
        return scale * ramp(t, length_s) * std::sin(kTurn * turns(t));
      };
      runs.push_back(imposed_run(limits, frame, name, speed, part));
    } else {
      const double most_A = scale * limits.current_A(0.0, 1.0);
      runs.push_back(
          driven_run(frame, name, [&](double t) { return most_A * std::cos(kTurn * turns(t)); }));
    }
  }
  return runs;
}

std::string excitation_csv(const std::vector<ExcitationRun>& runs) {
  const bool has_runs = !runs.front().name.empty();
  const bool is_imposed = !runs.front().excitation.joints[0].speed_rad_s.empty();
  std::string text = has_runs ? "run," : "";
  text +=
      is_imposed ? "time_s,motor_current_A,output_velocity_rad_s\n" : "time_s,motor_current_A\n";
  for (const ExcitationRun& run : runs) {
    const simulation::JointDrive& joint = run.excitation.joints[0];
    for (std::size_t i = 0; i < joint.value.size(); ++i) {
      if (has_runs) text += run.name + ",";
      text += fmt::format("{},{:.6g}", run.excitation.time_s[i], joint.value[i]);
      if (is_imposed) text += fmt::format(",{:.6g}", joint.speed_rad_s[i]);
      text += '\n';
    }
  }
  return text;
}

}  // namespace torquewright::identification
