// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/oracles/bench_log/band.hpp"
#include "tests/oracles/bench_log/documents.hpp"
#include "tests/oracles/bench_log/draw.hpp"

namespace torquewright::oracles {
namespace {

double rms_of_effect(const Bench& bench, const Dial& dial, double strength, std::size_t stride) {
  Bench trial = bench;
  trial.truth = bench.nominal;
  trial.faults = {};
  TrueEffect effect = dial.effect;
  dial.set(trial, effect, strength);
  std::vector<CleanRun> runs;
  for (std::size_t r = 0; r < trial.runs.size(); r += stride) {
    runs.push_back(measure(trial, simulate(trial.truth, trial.runs[r])));
  }
  return residual_rms(runs, dial.effect.equation, sample_rate_Hz(trial));
}

double floor_of(const Bench& bench, const std::string& equation) {
  return noise_floors(bench).at(equation);
}

// The floor is homogeneous in the noise of the equation's channels, resolution included.
void turn_noise(Bench& bench, const std::string& equation, double factor) {
  static const std::map<std::string, std::set<std::string>, std::less<>> kChannels{
      {"torque",
       {"output_position_rad", "linear_position_m", "output_velocity_rad_s", "linear_velocity_m_s",
        "motor_current_A", "output_torque_Nm"}},
      {"kinematic", {"output_position_rad", "motor_position_rad"}},
      {"electrical",
       {"winding_voltage_V", "motor_current_A", "output_position_rad", "output_velocity_rad_s"}},
      {"bus", {"bus_voltage_V"}},
      {"velocity",
       {"output_position_rad", "output_velocity_rad_s", "linear_position_m",
        "linear_velocity_m_s"}}};
  for (Channel& channel : bench.channels) {
    if (!kChannels.at(equation).contains(channel.quantity)) continue;
    channel.sigma *= factor;
    channel.resolution *= factor;
  }
}

}  // namespace

double tune(Bench& bench, Dial& dial, double multiple) {
  const std::string& equation = dial.effect.equation;
  const double target = multiple * floor_of(bench, equation);
  // Turned on every third run, then measured on all.
  constexpr std::size_t kStride = 3;
  double strength = dial.start;
  double rms = rms_of_effect(bench, dial, strength, kStride);
  for (int turn = 0; turn < 4 && std::abs(rms / target - 1.0) > 0.05; ++turn) {
    const double next = std::clamp(strength * target / rms, dial.least, dial.most);
    if (next == strength) break;
    strength = next;
    rms = rms_of_effect(bench, dial, strength, kStride);
  }
  rms = rms_of_effect(bench, dial, strength, 1);
  const double off = rms / target;
  if (off > 1.05 || off < 1.0 / 1.05) turn_noise(bench, equation, off);
  dial.effect.residual_rms = rms;
  return strength;
}

Scenario make_scenario(const Bench& bench, Truth truth, std::uint64_t seed, Chance& chance) {
  Scenario scenario;
  scenario.seed = seed;
  scenario.one_file = bench.one_file;
  scenario.name = name_of(truth.log_class);
  for (const TrueEffect& effect : truth.effects) scenario.name += ' ' + effect.effect;
  if (!truth.phenomenon.empty()) scenario.name += ' ' + truth.phenomenon;
  if (!truth.situation.empty()) scenario.name += ' ' + truth.situation;
  scenario.name += " seed " + std::to_string(seed);
  scenario.log.columns = {"t_s"};
  for (const Channel& channel : bench.channels) {
    scenario.log.columns.push_back(channel.column);
    truth.noise.push_back({channel.quantity, channel.sigma, channel.resolution});
  }
  if (bench.has_ignored_column) scenario.log.columns.push_back("row");
  for (const RunPlan& plan : bench.runs) {
    const CleanRun clean = measure(bench, simulate(bench.truth, plan));
    LogRun run = with_noise(bench, clean, plan.name, chance);
    if (bench.has_ignored_column) {
      run.columns.emplace_back();
      for (std::size_t k = 0; k < clean.time_s.size(); ++k) {
        run.columns.back().push_back(static_cast<double>(k));
      }
    }
    scenario.log.runs.push_back(std::move(run));
  }
  truth.noise_floor_rms = noise_floors(bench);
  for (TrueEffect& effect : truth.effects) {
    const auto floor = truth.noise_floor_rms.find(effect.equation);
    if (floor == truth.noise_floor_rms.end()) continue;  // The channels allow no such equation.
    effect.noise_multiple = effect.residual_rms / floor->second;
  }
  scenario.rig = rig_document(bench);
  scenario.actuator = actuator_document(bench);
  scenario.truth = std::move(truth);
  return scenario;
}

}  // namespace torquewright::oracles
