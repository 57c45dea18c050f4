// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_search/simulated_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "actuator/effects/every_effect.hpp"
#include "actuator/effects/library.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/rollout/parabola.hpp"

namespace torquewright::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Ranges;

constexpr double kNearly = 0.99;      ///< Of samples: what is beyond is noise.
constexpr double kShapeShare = 0.02;  ///< Of the motion's width: how far an angle moves at once.
constexpr double kScaleReach = 30.0;  ///< Times where a scale begins.
constexpr double kScaleShare = 0.3;
constexpr double kRatio = 0.1;  ///< Of what has no unit.

/// Laws without a winding's or a temperature's part, which no position shows apart, and without
/// parts of an elastic train: a simulation of them takes ten times as long.
constexpr std::array kAsked = {
    &actuator::effects::load_dependent_friction,
    &actuator::effects::asymmetric_friction,
    &actuator::effects::stribeck_friction,
    &actuator::effects::quadratic_drag,
    &actuator::effects::parallel_spring,
    &actuator::effects::upper_end_stop,
    &actuator::effects::lower_end_stop,
    &actuator::effects::torque_constant_error,
    &actuator::effects::torque_lag,
};

bool ends_with(std::string_view text, std::string_view end) { return text.ends_with(end); }

double nearly_most(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto place = values.begin() +
                     static_cast<std::ptrdiff_t>(kNearly * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Least and greatest position of a joint.
std::pair<double, double> travel_rad(const Log& log, std::size_t joint) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Run& run : log.runs) {
    for (const double each : run.joints[joint][Quantity::kOutputPosition]) {
      low = std::min(low, each);
      high = std::max(high, each);
    }
  }
  return {low, high};
}

/// "coulomb_positive_Nm" -> "coulomb_Nm": the law of both directions.
std::string of_both(std::string name) {
  for (const char* side : {"_positive", "_negative"}) {
    const std::size_t at = name.find(side);
    if (at != std::string::npos) name.erase(at, std::string_view(side).size());
  }
  return name;
}

/// What the drive has of the same number in a law that this one contains; nothing if none.
const double* contained(const actuator::Actuator& drive, const EffectKind& kind,
                        const std::string& parameter) {
  for (const Effect& own : drive.effects) {
    const auto& contains = kind.contains;
    if (std::find(contains.begin(), contains.end(), own.kind->name) == contains.end()) continue;
    for (std::size_t p = 0; p < own.values.size(); ++p) {
      if (own.kind->parameters[p].name == of_both(parameter)) return &own.values[p];
    }
  }
  return nullptr;
}

/// The effect at a start, saying what the laws say that it contains.
Effect at_start(const actuator::Actuator& drive, const EffectKind& kind,
                const std::vector<double>& start, double middle_rad) {
  Effect effect = actuator::neutral(kind);
  effect.provenance = "identified";
  effect.values = start;
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    const actuator::Parameter& parameter = kind.parameters[p];
    if (ends_with(parameter.name, "angle_rad")) effect.values[p] += middle_rad;
    if (const double* own = contained(drive, kind, std::string(parameter.name))) {
      effect.values[p] = *own;
    } else if (!parameter.at_least.empty()) {
      for (std::size_t q = 0; q < p; ++q) {
        if (kind.parameters[q].name == parameter.at_least) effect.values[p] = effect.values[q];
      }
    }
  }
  return effect;
}

/// Whether an effect says no more than the drive's own laws do.
bool is_nothing_in(const actuator::Actuator& drive, const Effect& effect) {
  const Effect neutral = actuator::neutral(*effect.kind);
  for (const FreeValue& each : values_of_effect(effect, 0, {})) {
    if (!is_amplitude(effect, each) || each.of == FreeValue::Of::kWave) continue;
    const bool is_own = contained(drive, *effect.kind, each.name) != nullptr ||
                        !effect.kind->parameters[each.parameter].at_least.empty();
    if (!is_own && effect.values[each.parameter] != neutral.values[each.parameter]) return false;
  }
  return true;
}

}  // namespace

Ranges ranges_of_joint(const Log& log, const RobotModel& model, std::size_t joint) {
  std::vector<double> speeds, accelerations, torques;
  for (const Run& run : log.runs) {
    const std::vector<double>& position = run.joints[joint][Quantity::kOutputPosition];
    const std::vector<double>& command = run.joints[joint][Quantity::kCommandedPosition];
    const std::size_t half = half_of_parabola(run.time_s);
    for (std::size_t at = half; at + half < run.time_s.size(); at += half) {
      const Motion now = parabola(run.time_s, position, at, half);
      const double torque_Nm =
          model.controllers[joint].law.torque_Nm(command[at], now.position_rad, now.speed_rad_s);
      if (!std::isfinite(now.acceleration_rad_s2) || !std::isfinite(torque_Nm)) continue;
      speeds.push_back(std::abs(now.speed_rad_s));
      accelerations.push_back(std::abs(now.acceleration_rad_s2));
      torques.push_back(std::abs(torque_Nm));
    }
  }
  const auto [low, high] = travel_rad(log, joint);
  Ranges ranges;
  ranges.speed_rad_s = std::max(1e-6, nearly_most(speeds));
  ranges.acceleration_rad_s2 = std::max(1e-6, nearly_most(accelerations));
  ranges.torque_Nm = std::max(1e-6, nearly_most(torques));
  ranges.angle_rad = std::max(1e-6, high - low);
  return ranges;
}

bool any_is_asked(const std::function<bool(const std::string& effect)>& asks) {
  return std::any_of(kAsked.begin(), kAsked.end(),
                     [&](const EffectKind* kind) { return asks(std::string(kind->name)); });
}

std::vector<SimulatedCandidate> simulated_candidates(
    const Log& log, const RobotModel& model, std::size_t joint,
    const std::function<bool(const std::string& effect)>& asks) {
  const Ranges ranges = ranges_of_joint(log, model, joint);
  const auto [low, high] = travel_rad(log, joint);
  const actuator::Actuator& drive = model.drives[joint];
  std::vector<SimulatedCandidate> all;
  for (const EffectKind* kind : kAsked) {
    const bool is_stated = std::any_of(drive.effects.begin(), drive.effects.end(),
                                       [&](const Effect& each) { return each.kind == kind; });
    if (is_stated || !asks(std::string(kind->name))) continue;
    std::vector<std::vector<double>> starts = {actuator::neutral(*kind).values};
    if (kind->starts != nullptr) starts = kind->starts(ranges);
    for (const std::vector<double>& start : starts) {
      SimulatedCandidate one{joint, at_start(drive, *kind, start, 0.5 * (low + high))};
      one.is_nothing = is_nothing_in(drive, one.effect);
      all.push_back(std::move(one));
    }
  }
  // Over less than a turn one wave stands for any slow rise and fall.
  Effect wave = actuator::neutral(actuator::effects::position_dependent_friction);
  wave.harmonics = {{1.0, 0.0, 0.0}};
  if (!has_wave_of_friction(drive)) all.push_back({joint, wave});
  return all;
}

actuator::Actuator with_effect(actuator::Actuator drive, const Effect& effect) {
  const auto& contains = effect.kind->contains;
  std::erase_if(drive.effects, [&](const Effect& own) {
    return own.kind == effect.kind ||
           std::find(contains.begin(), contains.end(), own.kind->name) != contains.end();
  });
  drive.effects.push_back(effect);
  return drive;
}

std::vector<FreeValue> values_of_effect(const Effect& effect, std::size_t joint,
                                        const Ranges& ranges) {
  std::vector<FreeValue> values;
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    const actuator::Parameter& parameter = effect.kind->parameters[p];
    FreeValue one;
    one.of = FreeValue::Of::kEffect;
    one.joint = joint;
    one.effect = std::string(effect.kind->name);
    one.parameter = p;
    one.name = std::string(parameter.name);
    one.lowest = parameter.lowest;
    one.highest = parameter.highest;
    if (parameter.is_scale) {
      one.lowest = effect.values[p] / kScaleReach;
      one.highest = effect.values[p] * kScaleReach;
      one.size = kScaleShare * effect.values[p];
    } else if (ends_with(parameter.name, "angle_rad")) {
      one.size = kShapeShare * ranges.angle_rad;
    } else {
      const double size = size_of(parameter.name, ranges);
      one.size = size == 1.0 ? kRatio : parameter.steepness * size;
    }
    values.push_back(std::move(one));
  }
  for (std::size_t part = 0; part < 2 * effect.harmonics.size(); ++part) {
    FreeValue one;
    one.of = FreeValue::Of::kWave;
    one.joint = joint;
    one.effect = std::string(effect.kind->name);
    one.parameter = part;
    one.name = "wave";
    one.lowest = -std::numeric_limits<double>::infinity();
    one.size = effect.proportional ? kRatio : kRatio * ranges.torque_Nm;
    values.push_back(std::move(one));
  }
  return values;
}

bool is_amplitude(const Effect& effect, const FreeValue& value) {
  if (value.of == FreeValue::Of::kWave) return true;
  const actuator::Parameter& parameter = effect.kind->parameters[value.parameter];
  return !parameter.is_scale && !ends_with(parameter.name, "angle_rad");
}

bool is_possible(const Effect& effect) {
  for (std::size_t p = 0; p < effect.values.size(); ++p) {
    for (std::size_t q = 0; q < effect.values.size(); ++q) {
      const bool is_bound = effect.kind->parameters[p].at_least == effect.kind->parameters[q].name;
      if (is_bound && effect.values[p] < effect.values[q]) return false;
    }
  }
  return true;
}

}  // namespace torquewright::identification
