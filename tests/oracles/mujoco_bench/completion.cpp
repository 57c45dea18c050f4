// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/completion.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr double kLeastFloors = 0.8;

World without(const Situation& it, std::size_t left_out) {
  World world = it.stated;
  for (std::size_t k = 0; k < it.missing.size(); ++k)
    if (k != left_out) put_on(world, it.missing[k]);
  return world;
}

/// The scale at which the effect is as large as asked on these records; at most 1. Secants in
/// logarithms: sizes grow with some power of the scale, saturation's with its exponent.
double fit_scale(const Situation& it, const ByScale& by_scale, double size,
                 const std::vector<Record>& records, const Levels& noise) {
  double scale = 0.1, power = 1, last_scale = 0, last_size = 0;
  for (int k = 0; k < 8; ++k) {
    World with = it.bench.world;
    put_on(with, by_scale(scale));
    const double now = floors(differences(with, it.bench.world, it.format, records), noise);
    if (!(now > 0)) return 1;
    if (std::abs(size / now - 1) < 0.05) break;
    if (last_size > 0 && scale != last_scale)
      power = std::clamp(std::log(now / last_size) / std::log(scale / last_scale), 0.3, 4.0);
    last_scale = scale, last_size = now;
    scale = std::clamp(scale * std::pow(size / now, 1 / power), 1e-5, 1.0);
    if (scale == last_scale) break;
  }
  return scale;
}

double rms(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += x * x;
  return std::sqrt(sum / static_cast<double>(numbers.size()));
}

double share_moving(const Record& record, double speed) {
  const auto moving = std::count_if(record.speed_rad_s.begin(), record.speed_rad_s.end(),
                                    [&](double w) { return std::abs(w) > speed; });
  return static_cast<double>(moving) / static_cast<double>(record.speed_rad_s.size());
}

/// A few of the runs, from first to last.
Bench pilot(const Bench& bench) {
  constexpr std::size_t kRuns = 4;
  Bench few = bench;
  few.recipes.clear();
  const std::size_t stride = (bench.recipes.size() + kRuns - 1) / kRuns;
  for (std::size_t k = 0; k < bench.recipes.size(); k += stride)
    few.recipes.push_back(bench.recipes[k]);
  return few;
}

/// The drive works, within its limits, and the load moves.
bool is_realisable(const Situation& it, const std::vector<Record>& records) {
  const double peak = it.bench.world.motor.peak_current_A;
  double current = 0, moving = 0;
  for (const Record& record : records) {
    current = std::max(current, rms(record.current_A) / peak);
    moving += share_moving(record, 1e-3 * it.top_speed_rad_s) / static_cast<double>(records.size());
    const auto [low, high] =
        std::minmax_element(record.position_rad.begin(), record.position_rad.end());
    if (!std::isfinite(rms(record.speed_rad_s))) return false;
    if (rms(record.speed_rad_s) > 2.5 * it.top_speed_rad_s) return false;
    if (it.stated.load.type == "pendulum" && *high - *low > 12) return false;
  }
  return current > 0.03 && current < 0.95 && moving > 0.75;
}

}  // namespace

void declare(Situation& it, Draws& draws, double probability,
             const std::vector<std::string>& missing) {
  static const std::vector<std::string> kUsual = {"viscous_friction", "coulomb_friction",
                                                  "stribeck_friction", "quadratic_drag"};
  std::vector<std::string> choices = kUsual;
  if (it.format.has("output_torque_Nm")) {
    choices.insert(choices.end(), {"gear_ripple", "load_dependent_friction"});
    if (!it.bench.voltage_driven) choices.emplace_back("torque_constant_saturation");
  }
  if (it.format.has("duty")) choices.insert(choices.end(), {"voltage_sag", "inverter_dead_time"});
  for (int k = 0; k < 2; ++k) {
    if (!draws.chance(probability)) continue;
    const std::string name = draws.one_of(choices);
    const auto fits = [&](const std::string& other) { return agree(name, other); };
    bool all_fit = std::all_of(missing.begin(), missing.end(), fits);
    for (const Effect& other : it.declared) all_fit = all_fit && fits(other.name);
    if (all_fit) it.declared.push_back(make_effect(name, draws.uniform(0.1, 0.5), it, draws));
    probability *= 0.4;
  }
}

void state_declared(Situation& it) {
  for (const Effect& effect : it.declared) put_on(it.stated, effect);
  it.bench.world = it.stated;
}

std::optional<Made> complete(Situation it, const std::vector<ByScale>& missing, Draws& draws,
                             SizeRange size) {
  std::vector<Record> records = play(missing.empty() ? it.bench : pilot(it.bench));
  const Draws noise_draws(draws.next());
  const Levels noise = noise_levels(it.bench.world, it.format, records, noise_draws);
  for (const ByScale& by_scale : missing) {
    const double floors_asked = draws.log_uniform(size.low, size.high);
    it.missing.push_back(by_scale(fit_scale(it, by_scale, floors_asked, records, noise)));
  }
  for (const Effect& effect : it.missing) put_on(it.bench.world, effect);
  if (!missing.empty()) records = play(it.bench);
  if (!is_realisable(it, records)) return std::nullopt;
  for (std::size_t k = 0; k < it.missing.size(); ++k) {
    const Levels levels = differences(it.bench.world, without(it, k), it.format, records);
    it.size_floors.push_back(floors(levels, noise));
    if (it.size_floors.back() < kLeastFloors) return std::nullopt;
  }
  it.noise_Nm = noise.at("torque_Nm");
  return Made{it, records};
}

}  // namespace torquewright::oracles::mujoco_bench
