// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/sampled_bench/classes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "tests/oracles/sampled_bench/candidates.hpp"
#include "tests/oracles/sampled_bench/excitation.hpp"
#include "tests/oracles/sampled_bench/outside.hpp"
#include "tests/oracles/sampled_bench/random_plant.hpp"
#include "tests/oracles/sampled_bench/rigging.hpp"
#include "tests/oracles/sampled_bench/sizes.hpp"

namespace torquewright::oracles::sampled {
namespace {

constexpr int kMostDraws = 200;
/// The integrator's own error, over the noise.
constexpr double kNumerical_floors = 0.2;

LoadKind draw_load(Draw& draw) {
  const double share = draw.uniform();
  if (share < 0.42) return LoadKind::kImposedSpeed;
  if (share < 0.56) return LoadKind::kBrake;
  if (share < 0.78) return LoadKind::kPendulum;
  return share < 0.96 ? LoadKind::kFree : LoadKind::kLinearAxis;
}

DriveKind draw_drive(Draw& draw) {
  const double share = draw.uniform();
  if (share < 0.65) return DriveKind::kCurrent;
  if (share < 0.85) return DriveKind::kDuty;
  return share < 0.93 ? DriveKind::kWindingVoltage : DriveKind::kCommandedTorque;
}

Needs merged(const Names& hidden, bool is_quiet) {
  Needs all;
  all.is_quiet = is_quiet;
  for (const std::string& name : hidden) {
    const Needs one = needs_of(name);
    all.both_encoders |= one.both_encoders;
    all.velocity |= one.velocity;
    all.temperature |= one.temperature;
    all.bus |= one.bus;
  }
  return all;
}

/// Without a temperature in the log the machine stays at the temperature of its data.
void keep_cool(Plant& plant) {
  plant.heating.winding_J_K *= 1e9;
  plant.heating.case_J_K *= 1e9;
}

/// What is fixed before the strengths are sought.
struct Outline {
  std::string kind;
  std::uint64_t seed = 0;
  Plant plant;
  Names hidden;
  Needs needs;
  Richness richness = Richness::kRich;
  std::string declared;
  bool is_hot = false;  ///< The whole log at one temperature above that of the data.
};

Situation furnish(const Outline& outline, Draw& draw) {
  Situation s;
  s.kind = outline.kind;
  s.seed = outline.seed;
  s.plant = outline.plant;
  if (!outline.needs.temperature || outline.is_hot) keep_cool(s.plant);
  const bool warm = outline.needs.temperature && !outline.is_hot;
  s.runs = draw_runs(s.plant, outline.richness, warm, draw);
  if (outline.is_hot) {
    for (RunPlan& run : s.runs) run.start_winding_K = kReference_K + 45.0;
  }
  s.chain = draw_chain(s.plant, s.runs, outline.needs, draw);
  if (!outline.declared.empty()) {
    const double strength = draw.uniform(0.1, 0.25);
    s.declared.push_back(draw_effect(outline.declared, strength, draw.bits(), s.plant, {}));
  }
  return s;
}

/// Whether the log is one that a bench would hand out.
bool is_realisable(const Bench& bench) {
  const Plant& plant = bench.situation.plant;
  std::size_t count = 0, clipped = 0;
  double square = 0.0, most = 0.0, hottest = 0.0;
  for (const RunLog& run : bench.log.runs) {
    for (const Instant& at : run.truth) {
      if (!std::isfinite(at.torque_Nm + at.speed_rad_s + at.current_A)) return false;
      ++count;
      clipped += std::abs(at.current_A) > 0.98 * plant.peak_current_A ? 1 : 0;
      square += at.speed_rad_s * at.speed_rad_s;
      most = std::max(most, std::abs(at.speed_rad_s));
      hottest = std::max(hottest, at.winding_K);
    }
  }
  const auto samples = static_cast<double>(count);
  return static_cast<double>(clipped) < 0.01 * samples && most < 4.0 * plant.used_speed_rad_s &&
         std::sqrt(square / samples) > 0.05 * plant.used_speed_rad_s && hottest < 420.0;
}

/// Seeks the strength that gives a size; sizes grow with a power of the strength.
template <typename SizeOf>
double strength_for(double floors, const SizeOf& size_of) {
  double strength = 0.1;
  double power = 1.0;
  double last_strength = 0.0, last_size = 0.0;
  for (int pass = 0; pass < 4; ++pass) {
    const double size = size_of(strength);
    if (!(size > 0.0)) return 1.0;
    if (std::abs(std::log(size / floors)) < 0.2) return strength;
    if (last_size > 0.0 && strength != last_strength && size != last_size) {
      power = std::clamp(std::log(size / last_size) / std::log(strength / last_strength), 0.5, 4.0);
    }
    last_strength = strength;
    last_size = size;
    const double next = std::clamp(strength * std::pow(floors / size, 1.0 / power), 1e-4, 1.0);
    if (next == strength) return strength;
    strength = next;
  }
  return strength;
}

/// A bench of fewer runs, for probing.
Situation shortened(const Situation& situation) {
  Situation few = situation;
  if (few.runs.size() > 4) few.runs.resize(4);
  for (RunPlan& run : few.runs) run.duration_s = std::min(run.duration_s, 6.0);
  return few;
}

double probe(const Situation& situation) {
  const Record log = record(situation);
  const Record clean = record_without_faults(situation, log);
  return size_floors(situation, log, clean).back();
}

/// Adds effects of sizes drawn log-uniformly over 1 to 300.
void hide(Situation& situation, const Names& names, Draw& draw) {
  for (const std::string& name : names) {
    const double floors = draw.log_uniform(1.0, 300.0);
    const std::uint64_t seed = draw.bits();
    const Laws stated = stated_laws(situation);
    Situation few = shortened(situation);
    few.hidden.push_back({});
    const double strength = strength_for(floors, [&](double trial) {
      few.hidden.back() = draw_effect(name, trial, seed, situation.plant, stated);
      return probe(few);
    });
    situation.hidden.push_back(draw_effect(name, strength, seed, situation.plant, stated));
  }
}

Bench finished(Situation situation) {
  Bench bench;
  bench.log = record(situation);
  bench.faultless = record_without_faults(situation, bench.log);
  bench.size_floors = size_floors(situation, bench.log, bench.faultless);
  bench.situation = std::move(situation);
  return bench;
}

/// A lag so short that a delay of a channel is as good an account of it.
void accept_short_lags(Bench& bench) {
  constexpr double kSeen_floors = 5.0;
  Situation& s = bench.situation;
  for (std::size_t k = 0; k < s.hidden.size(); ++k) {
    const Effect& effect = s.hidden[k];
    const bool lag = effect.name == "torque_lag";
    const bool late_torque =
        effect.name == "channel_delay" && effect.parameters.at("channel") == "output_torque_Nm";
    if (!lag && !late_torque) continue;
    const double time_s = effect.parameters.at(lag ? "time_constant_s" : "delay_s");
    if (lag_against_delay_floors(s, bench.faultless, std::max(1e-5, time_s)) < kSeen_floors) {
      s.accept[k].emplace_back(lag ? "channel_delay" : "torque_lag");
    }
  }
}

void state_uncertain(Situation& s, Draw& draw) {
  for (const Effect& effect : s.hidden) {
    if (effect.name == "load_inertia_error") s.uncertain.emplace_back("/load/inertia_kg_m2");
    if (effect.name == "load_mass_error") s.uncertain.emplace_back("/load/mass_kg");
  }
  const LoadKind kind = s.plant.load.kind;
  const bool sensorless = kind == LoadKind::kPendulum || kind == LoadKind::kFree;
  if (s.uncertain.empty() && sensorless && draw.chance(0.2)) {
    s.uncertain.emplace_back("/motor/torque_constant_Nm_A");
  }
}

Names draw_hidden(const std::string& kind, const Plant& plant, Draw& draw) {
  if (kind == "coulomb_load") return {"coulomb_friction", "load_dependent_friction"};
  if (kind == "none" || kind == "outside") return {};
  const Names all = candidates(plant);
  Names hidden{draw.one_of(all)};
  while (kind == "two" && hidden.size() < 2) {
    const std::string& other = draw.one_of(all);
    if (are_separable(hidden.front(), other)) hidden.push_back(other);
  }
  return hidden;
}

Bench rich_bench(const std::string& kind, std::uint64_t seed, Draw& draw) {
  Outline outline;
  outline.kind = kind;
  outline.seed = seed;
  const bool dynamometer = kind == "coulomb_load";
  const LoadKind load = dynamometer ? LoadKind::kImposedSpeed : draw_load(draw);
  outline.plant = random_plant(load, dynamometer ? DriveKind::kCurrent : draw_drive(draw), draw);
  outline.hidden = draw_hidden(kind, outline.plant, draw);
  outline.needs = merged(outline.hidden, dynamometer);
  if (kind == "none" && draw.chance(0.4)) outline.needs.temperature = true;
  outline.declared = dynamometer ? "" : draw_declared(outline.plant, outline.hidden, draw);
  Situation s = furnish(outline, draw);
  hide(s, outline.hidden, draw);
  for (const Effect& effect : s.hidden) s.accept.push_back(equals_of(effect, s.plant));
  state_uncertain(s, draw);
  Bench bench = finished(std::move(s));
  accept_short_lags(bench);
  return bench;
}

/// Poor excitation, what hides in it, and all names that would do.
struct PoorKind {
  std::string hidden;
  LoadKind load;
  Richness richness;
  bool is_hot;
  Names accept;
  std::string note;
};

const std::vector<PoorKind>& poor_kinds() {
  using enum LoadKind;
  static const Names kConstants{"coulomb_friction",
                                "viscous_friction",
                                "quadratic_drag",
                                "stribeck_friction",
                                "asymmetric_friction",
                                "load_dependent_friction",
                                "presliding_friction",
                                "torque_offset",
                                "current_offset",
                                "torque_constant_error",
                                "torque_constant_saturation"};
  static const Names kOffsets{"torque_constant_error", "torque_constant_saturation",
                              "torque_offset", "current_offset", "asymmetric_friction"};
  static const std::string kPoint = "one speed, one direction, one load";
  static const std::string kLoadOnly = "one load";
  static const Names kDry{"coulomb_friction", "load_dependent_friction", "asymmetric_friction"};
  static const std::vector<PoorKind> kKinds{
      {"coulomb_friction", kImposedSpeed, Richness::kOneSpeed, false, kConstants, kPoint},
      {"viscous_friction", kImposedSpeed, Richness::kOneSpeed, false, kConstants, kPoint},
      {"torque_constant_error", kImposedSpeed, Richness::kOneSpeed, false, kConstants, kPoint},
      {"torque_constant_error", kImposedSpeed, Richness::kOneLoad, false, kOffsets, kLoadOnly},
      {"torque_offset", kImposedSpeed, Richness::kOneLoad, false, kOffsets, kLoadOnly},
      {"coulomb_friction", kImposedSpeed, Richness::kOneLoad, false, kDry, kLoadOnly},
      {"torque_constant_temperature",
       kImposedSpeed,
       Richness::kRich,
       true,
       {"torque_constant_temperature", "torque_constant_error"},
       "one temperature"},
      {"viscous_friction",
       kFree,
       Richness::kOneSine,
       false,
       {"viscous_friction", "channel_delay"},
       "a single sinusoid"},
      {"reflected_inertia",
       kFree,
       Richness::kOneSine,
       false,
       {"reflected_inertia", "load_inertia_error", "torque_constant_error"},
       "a single sinusoid"}};
  return kKinds;
}

Bench poor_bench(std::uint64_t seed, Draw& draw) {
  const PoorKind& poor = draw.one_of(poor_kinds());
  Outline outline;
  outline.kind = "undecidable";
  outline.seed = seed;
  outline.plant = random_plant(poor.load, DriveKind::kCurrent, draw);
  outline.hidden = {poor.hidden};
  outline.needs = merged(outline.hidden, false);
  outline.richness = poor.richness;
  outline.is_hot = poor.is_hot;
  Situation s = furnish(outline, draw);
  hide(s, outline.hidden, draw);
  s.accept = {poor.accept};
  s.note = poor.note;
  return finished(std::move(s));
}

Bench outside_bench(std::uint64_t seed, Draw& draw) {
  const OutsideKind& kind = draw.one_of(outside_kinds());
  Outline outline;
  outline.kind = "outside";
  outline.seed = seed;
  outline.plant = random_plant(kind.load, DriveKind::kCurrent, draw);
  outline.needs.both_encoders = kind.both_encoders;
  outline.declared =
      kind.dry_friction ? "coulomb_friction" : draw_declared(outline.plant, {}, draw);
  Situation s = furnish(outline, draw);
  const std::uint64_t shape = draw.bits();
  Situation few = shortened(s);
  const double strength = strength_for(draw.log_uniform(1.0, 300.0), [&](double trial) {
    set_outside(few, kind, trial, shape);
    return probe(few);
  });
  set_outside(s, kind, strength, shape);
  return finished(std::move(s));
}

Bench draw_once(const std::string& kind, std::uint64_t seed, Draw& draw) {
  if (kind == "undecidable") return poor_bench(seed, draw);
  if (kind == "outside") return outside_bench(seed, draw);
  return rich_bench(kind, seed, draw);
}

}  // namespace

const std::vector<std::string>& class_names() {
  static const std::vector<std::string> kNames{"none",        "one",     "two",
                                               "undecidable", "outside", "coulomb_load"};
  return kNames;
}

Bench draw_bench(const std::string& kind, std::uint64_t seed) {
  Draw draw(seed);
  for (int attempt = 0; attempt < kMostDraws; ++attempt) {
    Bench bench = draw_once(kind, seed, draw);
    const bool seen = std::all_of(bench.size_floors.begin(), bench.size_floors.end(),
                                  [](double floors) { return floors >= 0.8; });
    if (seen && is_realisable(bench) &&
        numerical_floors(bench.situation, bench.faultless) < kNumerical_floors) {
      return bench;
    }
  }
  throw std::runtime_error("no situation of class " + kind + " could be built");
}

}  // namespace torquewright::oracles::sampled
