// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/oracles/mujoco_bench/completion.hpp"
#include "tests/oracles/mujoco_bench/outside.hpp"
#include "tests/oracles/mujoco_bench/undecidable.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

constexpr int kMostRedraws = 200;

/// Values of the load that are wrong are listed; the torque constant now and then.
void draw_uncertain(Situation& it, Draws& draws) {
  bool frees_constant = it.missing.empty() && !it.format.has("output_torque_Nm") &&
                        !it.bench.voltage_driven && draws.chance(0.25);
  for (const Effect& effect : it.missing) {
    if (effect.name == "load_inertia_error") it.uncertain.emplace_back("/load/inertia_kg_m2");
    if (effect.name == "load_mass_error") it.uncertain.emplace_back("/load/mass_kg");
    if (effect.name == "torque_constant_error") frees_constant = draws.chance(0.3);
  }
  if (frees_constant) it.uncertain.emplace_back("/motor/torque_constant_Nm_A");
}

void draw_holdout(Situation& it, Draws& draws) {
  if (it.bench.recipes.size() > 3 && draws.chance(0.15))
    it.holdout_runs = {it.bench.recipes.back().name, it.bench.recipes[1].name};
}

std::optional<Made> draw_none(Draws& draws, std::uint64_t /*turn*/) {
  Situation it = draw_rig(draws, {});
  declare(it, draws, 0.8, {});
  state_declared(it);
  return complete(it, {}, draws);
}

std::optional<Made> draw_one(Draws& draws, std::uint64_t turn) {
  const std::string name = effect_names()[turn % effect_names().size()];
  const Draws own(draws.next());
  Situation it = draw_rig(draws, demand_of(name, own));
  it.declared = companions(name, it, draws);
  declare(it, draws, 0.5, {name});
  state_declared(it);
  const auto by_scale = [&](double scale) { return make_effect(name, scale, it, own); };
  auto made = complete(it, {by_scale}, draws);
  if (made) made->situation.accept = {identical_names(made->situation.missing[0], it)};
  return made;
}

/// A rig that meets both, where there is one.
std::optional<Demand> both(const Demand& a, const Demand& b) {
  Demand demand = a;
  demand.loads.clear();
  for (const std::string& load : a.loads)
    if (std::find(b.loads.begin(), b.loads.end(), load) != b.loads.end())
      demand.loads.push_back(load);
  demand.temperature |= b.temperature;
  demand.two_encoders |= b.two_encoders;
  demand.velocity |= b.velocity;
  demand.fast_torque |= b.fast_torque;
  demand.gentle |= b.gentle;
  if (a.drive == "any") demand.drive = b.drive;
  const bool drives_differ = a.drive != b.drive && a.drive != "any" && b.drive != "any";
  const bool orders_differ =
      a.rotor_order + a.output_order > 0 && b.rotor_order + b.output_order > 0;
  demand.rotor_order = std::max(a.rotor_order, b.rotor_order);
  demand.output_order = std::max(a.output_order, b.output_order);
  if (demand.loads.empty() || drives_differ || orders_differ) return std::nullopt;
  return demand;
}

/// Correlation of what two effects change in one equation: from the sum's square.
bool are_apart(const Situation& it, const std::vector<Record>& records) {
  World neither = it.stated, first = it.stated, second = it.stated;
  put_on(first, it.missing[0]);
  put_on(second, it.missing[1]);
  const Levels a = differences(first, neither, it.format, records);
  const Levels b = differences(second, neither, it.format, records);
  const Levels sum = differences(it.bench.world, neither, it.format, records);
  for (const auto& [equation, whole] : sum) {
    const double product = a.at(equation) * b.at(equation);
    const double squares = a.at(equation) * a.at(equation) + b.at(equation) * b.at(equation);
    if (product > 0 && std::abs(whole * whole - squares) > 2 * 0.8 * product) return false;
  }
  return true;
}

bool share_a_name(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

std::optional<Made> draw_two(Draws& draws, std::uint64_t /*turn*/) {
  const std::string first = draws.one_of(effect_names()), second = draws.one_of(effect_names());
  const Draws own_first(draws.next()), own_second(draws.next());
  const auto demand = both(demand_of(first, own_first), demand_of(second, own_second));
  if (!demand || !agree(first, second)) return std::nullopt;
  Situation it = draw_rig(draws, *demand);
  for (const std::string& name : {first, second})
    for (const Effect& companion : companions(name, it, draws)) {
      if (!agree(companion.name, first) || !agree(companion.name, second)) return std::nullopt;
      it.declared.push_back(companion);
    }
  if (it.declared.size() > 2) return std::nullopt;
  state_declared(it);
  auto made = complete(it,
                       {[&](double scale) { return make_effect(first, scale, it, own_first); },
                        [&](double scale) { return make_effect(second, scale, it, own_second); }},
                       draws);
  if (!made) return std::nullopt;
  Situation& done = made->situation;
  for (const Effect& effect : done.missing) done.accept.push_back(identical_names(effect, it));
  if (share_a_name(done.accept[0], done.accept[1]) || !are_apart(done, made->records))
    return std::nullopt;
  return made;
}

std::optional<Made> draw_outside(Draws& draws, std::uint64_t turn) {
  const Outside& outside = outside_kinds()[turn % outside_kinds().size()];
  const Draws own(draws.next());
  Situation it = draw_rig(draws, outside.demand);
  declare(it, draws, 0.4, {});
  state_declared(it);
  auto made =
      complete(it, {[&](double scale) { return outside.make(scale, it, own); }}, draws, {3, 300});
  if (made) made->situation.outside_coordinates = outside.coordinates;
  return made;
}

/// Coulomb and load-dependent friction together, at a fifth of the usual noise.
std::optional<Made> draw_coulomb_load(Draws& draws, std::uint64_t /*turn*/) {
  const Draws own(draws.next());
  Situation it = draw_rig(draws, {.loads = {"dynamometer"}, .drive = "current"});
  for (auto& [quantity, grain] : it.format.grains) grain = {grain.noise / 5, grain.quantum / 5};
  auto made = complete(
      it,
      {[&](double scale) { return make_effect("coulomb_friction", scale, it, own); },
       [&](double scale) { return make_effect("load_dependent_friction", scale, it, own); }},
      draws, {20, 300});
  if (made) made->situation.accept = {{"coulomb_friction"}, {"load_dependent_friction"}};
  return made;
}

/// The turn, which is the seed, takes effects and kinds one after the other.
using ClassDraw = std::optional<Made> (*)(Draws& draws, std::uint64_t turn);

const std::map<std::string, ClassDraw> kClasses = {
    {"none", draw_none},       {"one", draw_one},
    {"two", draw_two},         {"undecidable", draw_undecidable},
    {"outside", draw_outside}, {"coulomb_load", draw_coulomb_load}};

}  // namespace

Made make_log(const std::string& kind, std::uint64_t seed) {
  const auto found = kClasses.find(kind);
  if (found == kClasses.end()) throw std::invalid_argument("no class is called " + kind);
  std::uint64_t mixed = seed;
  for (const char letter : kind) mixed = mixed * 131 + static_cast<unsigned char>(letter);
  Draws draws(mixed);
  for (int k = 0; k < kMostRedraws; ++k) {
    auto made = found->second(draws, seed);
    if (!made) continue;
    made->situation.kind = kind;
    draw_uncertain(made->situation, draws);
    draw_holdout(made->situation, draws);
    return *made;
  }
  throw std::runtime_error("no realisable situation was drawn");
}

}  // namespace torquewright::oracles::mujoco_bench
