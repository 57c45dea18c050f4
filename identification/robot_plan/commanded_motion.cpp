// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_plan/commanded_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace torquewright::identification {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kFade_s = 1.0;
constexpr double kSlowest_Hz = 0.1, kSlow_Hz = 0.6, kFast_Hz = 5.0;
constexpr double kFastShare = 0.3;  ///< Of the reach, at most: a fast wave is fast by its rate.

/// Turns of a wave until then: the integral of first (last/first)^(t/T).
double turns_at(const CommandedWave& wave, double time_s, double duration_s) {
  if (wave.first_Hz == wave.last_Hz) return wave.first_Hz * time_s;
  const double growth = std::log(wave.last_Hz / wave.first_Hz);
  return wave.first_Hz * duration_s / growth * std::expm1(growth * time_s / duration_s);
}

double fade_at(double time_s, double duration_s) {
  const double from_end_s = std::min(time_s, duration_s - time_s);
  if (from_end_s >= kFade_s) return 1.0;
  return 0.5 - 0.5 * std::cos(std::numbers::pi * std::max(0.0, from_end_s) / kFade_s);
}

std::size_t samples_of(double duration_s) {
  return static_cast<std::size_t>(std::lround(duration_s / kCommandStep_s)) + 1;
}

double drawn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

}  // namespace

std::vector<double> command_rad(const JointCommand& joint, double duration_s) {
  std::vector<double> command;
  for (std::size_t i = 0; i < samples_of(duration_s); ++i) {
    const double time_s = static_cast<double>(i) * kCommandStep_s;
    double sum = 0.0;
    for (const CommandedWave& wave : joint.waves) {
      sum += wave.share * std::sin(kTurn_rad * turns_at(wave, time_s, duration_s) + wave.phase_rad);
    }
    command.push_back(joint.centre_rad + joint.reach_rad * fade_at(time_s, duration_s) * sum);
  }
  return command;
}

void draw_waves(CommandedMotion& motion, std::mt19937_64& random) {
  for (JointCommand& joint : motion.joints) {
    const double fast = drawn(random, 0.0, kFastShare);
    const double slow = drawn(random, 0.4, 1.0) * (1.0 - fast);
    joint.waves.clear();
    for (const double share : {slow, 1.0 - fast - slow}) {
      const double rate_Hz = drawn(random, kSlowest_Hz, kSlow_Hz);
      joint.waves.push_back({share, rate_Hz, rate_Hz, drawn(random, 0.0, kTurn_rad)});
    }
    const double rate_Hz = kSlow_Hz * std::pow(kFast_Hz / kSlow_Hz, drawn(random, 0.0, 1.0));
    joint.waves.push_back({fast, rate_Hz, rate_Hz, drawn(random, 0.0, kTurn_rad)});
  }
}

void sweep(CommandedMotion& motion) {
  for (JointCommand& joint : motion.joints) joint.waves = {{1.0, kSlowest_Hz, kFast_Hz, 0.0}};
}

Log log_of(const std::vector<CommandedMotion>& motions) {
  Log log;
  for (const CommandedMotion& motion : motions) {
    Run run;
    run.name = motion.run;
    for (std::size_t i = 0; i < samples_of(motion.duration_s); ++i) {
      run.time_s.push_back(static_cast<double>(i) * kCommandStep_s);
    }
    for (const JointCommand& joint : motion.joints) {
      Channels& channels = run.joints.emplace_back();
      channels[Quantity::kCommandedPosition] = command_rad(joint, motion.duration_s);
      channels[Quantity::kOutputPosition] = channels[Quantity::kCommandedPosition];
    }
    run.masked.assign(run.time_s.size(), 0);
    log.train_runs.push_back(run.name);
    log.runs.push_back(std::move(run));
  }
  return log;
}

std::string commands_csv(const std::vector<CommandedMotion>& motions,
                         const std::vector<std::string>& joints) {
  std::string text = "run,time_s";
  for (const std::string& joint : joints) text += fmt::format(",{}_commanded_position_rad", joint);
  text += '\n';
  for (const CommandedMotion& motion : motions) {
    std::vector<std::vector<double>> columns;
    for (const JointCommand& joint : motion.joints)
      columns.push_back(command_rad(joint, motion.duration_s));
    for (std::size_t i = 0; i < samples_of(motion.duration_s); ++i) {
      text += fmt::format("{},{:.3f}", motion.run, static_cast<double>(i) * kCommandStep_s);
      for (const std::vector<double>& column : columns)
        fmt::format_to(std::back_inserter(text), ",{:.6f}", column[i]);
      text += '\n';
    }
  }
  return text;
}

}  // namespace torquewright::identification
