// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>

#include "tests/oracles/mujoco_bench/balance.hpp"
#include "tests/oracles/mujoco_bench/effects.hpp"
#include "tests/oracles/mujoco_bench/situation.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr int kMostRedraws = 30;

/// How an effect that is not there yet comes to be, by its scale.
using ByScale = std::function<Effect(double scale)>;

World without(const Situation& it, std::size_t left_out) {
  World world = it.stated;
  for (std::size_t k = 0; k < it.missing.size(); ++k)
    if (k != left_out) put_on(world, it.missing[k]);
  return world;
}

/// One or two effects beside the missing ones, with a tenth to half of their most.
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

/// The scale at which the effect is as large as asked on these records; at most 1.
double fit_scale(const Situation& it, const ByScale& by_scale, double size,
                 const std::vector<Record>& records, const Levels& noise) {
  double scale = 0.1;
  for (int k = 0; k < 5; ++k) {
    World with = it.bench.world;
    put_on(with, by_scale(scale));
    const double now = floors(differences(with, it.bench.world, it.format, records), noise);
    if (!(now > 0)) return 1;
    scale = std::clamp(scale * size / now, 1e-5, 1.0);
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
  return current > 0.03 && current < 0.95 && moving > 0.6;
}

/// Plays the situation without what is missing, sizes it, and plays it again with it.
std::optional<Made> complete(Situation it, const std::vector<ByScale>& missing, Draws& draws) {
  std::vector<Record> records = play(it.bench);
  const Draws noise_draws(draws.next());
  const Levels noise = noise_levels(it.bench.world, it.format, records, noise_draws);
  for (const ByScale& by_scale : missing) {
    const double size = draws.log_uniform(1, 300);
    it.missing.push_back(by_scale(fit_scale(it, by_scale, size, records, noise)));
  }
  for (const Effect& effect : it.missing) put_on(it.bench.world, effect);
  if (!missing.empty()) records = play(it.bench);
  if (!is_realisable(it, records)) return std::nullopt;
  for (std::size_t k = 0; k < it.missing.size(); ++k) {
    const Levels levels = differences(it.bench.world, without(it, k), it.format, records);
    it.size_floors.push_back(floors(levels, noise));
  }
  it.noise_Nm = noise.at("torque_Nm");
  return Made{it, records};
}

/// Values of the load that are wrong are listed; others now and then.
void draw_uncertain(Situation& it, Draws& draws) {
  for (const Effect& effect : it.missing) {
    if (effect.name == "load_inertia_error") it.uncertain.emplace_back("/load/inertia_kg_m2");
    if (effect.name == "load_mass_error") it.uncertain.emplace_back("/load/mass_kg");
    if (effect.name == "torque_constant_error" && draws.chance(0.3))
      it.uncertain.emplace_back("/motor/torque_constant_Nm_A");
  }
  if (it.missing.empty() && !it.format.has("output_torque_Nm") && draws.chance(0.25) &&
      !it.bench.voltage_driven)
    it.uncertain.emplace_back("/motor/torque_constant_Nm_A");
}

void draw_holdout(Situation& it, Draws& draws) {
  if (it.bench.recipes.size() > 3 && draws.chance(0.15))
    it.holdout_runs = {it.bench.recipes.back().name, it.bench.recipes[1].name};
}

/// Names the effect, plans a rig that shows it, and completes the log.
std::optional<Made> draw_one(Draws& draws) {
  const std::string name = draws.one_of(effect_names());
  const Draws own(draws.next());
  Situation it = draw_rig(draws, demand_of(name, own));
  it.declared = companions(name, it, draws);
  declare(it, draws, 0.5, {name});
  state_declared(it);
  const auto by_scale = [&](double scale) { return make_effect(name, scale, it, own); };
  auto made = complete(it, {by_scale}, draws);
  if (!made || made->situation.size_floors[0] < 0.8) return std::nullopt;
  made->situation.accept = {identical_names(made->situation.missing[0], it)};
  return made;
}

std::optional<Made> draw_none(Draws& draws) {
  Situation it = draw_rig(draws, {});
  declare(it, draws, 0.8, {});
  state_declared(it);
  return complete(it, {}, draws);
}

using ClassDraw = std::function<std::optional<Made>(Draws&)>;

const std::map<std::string, ClassDraw>& classes() {
  static const std::map<std::string, ClassDraw> all = {{"none", draw_none}, {"one", draw_one}};
  return all;
}

}  // namespace

Made make_log(const std::string& kind, std::uint64_t seed) {
  const auto found = classes().find(kind);
  if (found == classes().end()) throw std::invalid_argument("no class is called " + kind);
  std::uint64_t mixed = seed;
  for (const char letter : kind) mixed = mixed * 131 + static_cast<unsigned char>(letter);
  Draws draws(mixed);
  for (int k = 0; k < kMostRedraws; ++k) {
    auto made = found->second(draws);
    if (!made) continue;
    made->situation.kind = kind;
    draw_uncertain(made->situation, draws);
    draw_holdout(made->situation, draws);
    return *made;
  }
  throw std::runtime_error("no realisable situation was drawn");
}

}  // namespace torquewright::oracles::mujoco_bench
