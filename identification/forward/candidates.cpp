// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/candidates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/effects/library.hpp"
#include "optimization/fit/quantile.hpp"

namespace torquewright::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::Instant;
using actuator::Ranges;

constexpr double kScaleReachUp = 100.0;  ///< Of a scale, from its starts.
constexpr double kScaleReachDown = 30.0;
constexpr double kLongestDelay_s = 0.2;
constexpr double kLongestTime_s = 0.1;    ///< Of a lag.
constexpr double kMostCoefficient = 5.0;  ///< Of what has no unit.
constexpr double kLeastGain = 0.2;        ///< Of a current's sensor; the inverse of the greatest.

bool ends_with(std::string_view text, std::string_view end) { return text.ends_with(end); }

/// The largest magnitudes, but for 1 %.
class Largest {
 public:
  void take(double value) { values_.push_back(std::abs(value)); }
  double nearly_all() const {
    return values_.empty() ? 1e-6 : std::max(1e-6, optimization::lower_quantile(values_, 0.99));
  }
  double greatest() const {
    return values_.empty() ? 1e-6
                           : std::max(1e-6, *std::max_element(values_.begin(), values_.end()));
  }

 private:
  std::vector<double> values_;
};

/// What angles of stretches cover together, without what lies between those that are apart.
class Covered {
 public:
  void take(double low, double high) {
    if (high > low) spans_.emplace_back(low, high);
  }
  double length() {
    std::sort(spans_.begin(), spans_.end());
    double sum = 0.0, until = -INFINITY;
    for (const auto& [low, high] : spans_) {
      sum += std::max(0.0, high - std::max(low, until));
      until = std::max(until, high);
    }
    return std::max(1e-6, sum);
  }

 private:
  std::vector<std::pair<double, double>> spans_;
};

double highest_of(const actuator::Parameter& parameter, double size) {
  const std::string_view name = parameter.name;
  if (ends_with(name, "_1_K")) return parameter.highest;
  if (ends_with(name, "_s") && !ends_with(name, "rad_s")) return kLongestTime_s;
  if (size == 1.0) return std::min(parameter.highest, kMostCoefficient);
  return std::min(parameter.highest, size);
}

/// Of a parameter that stands before; none if there is none of that name.
std::size_t index_of(const EffectKind& kind, std::string_view name) {
  for (std::size_t p = 0; p < kind.parameters.size(); ++p) {
    if (kind.parameters[p].name == name) return p;
  }
  return FitParameter::kNone;
}

FitParameter fit_parameter(const EffectKind& kind, const Ranges& ranges,
                           const std::vector<std::vector<double>>& starts, std::size_t index) {
  const actuator::Parameter& parameter = kind.parameters[index];
  FitParameter fit;
  fit.name = parameter.name;
  fit.is_scale = parameter.is_scale;
  if (fit.is_scale) {
    double least = INFINITY, greatest = 0.0;
    for (const auto& start : starts) {
      least = std::min(least, start[index]);
      greatest = std::max(greatest, start[index]);
    }
    const bool is_exponent = size_of(parameter.name, ranges) == 1.0;
    fit.lowest = is_exponent ? 0.0 : std::log(least / kScaleReachDown);
    fit.highest = is_exponent ? std::log(8.0) : std::log(greatest * kScaleReachUp);
    return fit;
  }
  fit.above = index_of(kind, parameter.at_least);
  fit.size = parameter.steepness * size_of(parameter.name, ranges);
  fit.highest = highest_of(parameter, fit.size);
  fit.lowest = std::max(parameter.lowest, -fit.highest);
  return fit;
}

std::vector<std::vector<double>> starts_of(const EffectKind& kind, const Ranges& ranges) {
  if (kind.starts != nullptr) return kind.starts(ranges);
  return {actuator::neutral(kind).values};
}

/// What the document says of the same kind; empty if nothing.
std::vector<double> stated_values(const EffectKind& kind, const actuator::Actuator& stated) {
  for (const Effect& each : stated.effects) {
    if (each.kind == &kind) return each.values;
  }
  return {};
}

bool takes_place_of(const EffectKind& kind, const Effect& stated) {
  if (stated.kind == &kind) return true;
  return std::find(kind.contains.begin(), kind.contains.end(), stated.kind->name) !=
         kind.contains.end();
}

Effect effect_at(const EffectKind& kind, const std::vector<FitParameter>& parameters,
                 std::span<const double> coordinates) {
  Effect effect{&kind, {}, {}, false, "identified"};
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const std::size_t above = parameters[p].above;
    const double base = above == FitParameter::kNone ? 0.0 : effect.values[above];
    effect.values.push_back(base + parameters[p].value(coordinates[p]));
  }
  return effect;
}

/// The wave of a sine and a cosine.
FoundWave found_wave(double order, const char* amplitude, std::span<const double> u) {
  FoundWave wave;
  wave.order = order;
  wave.amplitude = {amplitude, std::hypot(u[0], u[1])};
  wave.phase_rad.value = std::atan2(u[1], u[0]);
  return wave;
}

}  // namespace

bool FitParameter::is_at_edge(double coordinate) const {
  if (coordinate >= highest) return true;
  return coordinate <= lowest && lowest != 0.0;
}
double FitParameter::coordinate(double value) const { return is_scale ? std::log(value) : value; }
double FitParameter::value(double coordinate) const {
  return is_scale ? std::exp(coordinate) : coordinate;
}

std::vector<std::string> nameable_effects() {
  std::vector<std::string> names = {"gravity_imbalance",  "torque_offset",     "channel_delay",
                                    "current_gain_error", "encoder_harmonics", "velocity_mismatch"};
  for (const EffectKind* each : actuator::effect_library()) names.emplace_back(each->name);
  return names;
}

actuator::Ranges ranges_of(const Bench& bench, const std::vector<Signals>& signals) {
  Largest torque, speed, acceleration, current;
  Covered angles, motor_angles;
  Ranges ranges;
  for (const Signals& stretch : signals) {
    double low = INFINITY, high = -INFINITY, motor_low = INFINITY, motor_high = -INFINITY;
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      const Instant& at = stretch.at[i];
      if (!stretch.motor_side_Nm.empty()) torque.take(stretch.motor_side_Nm[i]);
      if (!stretch.load_side_Nm.empty()) torque.take(stretch.load_side_Nm[i]);
      speed.take(at.speed_rad_s);
      acceleration.take(at.acceleration_rad_s2);
      current.take(at.current_A);
      low = std::min(low, at.output_angle_rad);
      high = std::max(high, at.output_angle_rad);
      motor_low = std::min(motor_low, at.motor_angle_rad);
      motor_high = std::max(motor_high, at.motor_angle_rad);
      ranges.warmth_K = std::max(ranges.warmth_K,
                                 std::abs(at.winding_temperature_K - at.reference_temperature_K));
    }
    angles.take(low, high);
    motor_angles.take(motor_low, motor_high);
  }
  ranges.angle_rad = angles.length();
  ranges.motor_angle_rad = motor_angles.length();
  ranges.torque_Nm = torque.greatest();
  ranges.speed_rad_s = speed.nearly_all();
  ranges.acceleration_rad_s2 = acceleration.nearly_all();
  ranges.current_A = current.greatest();
  ranges.voltage_V = bench.actuator().drive.bus_voltage_V;
  return ranges;
}

double size_of(std::string_view name, const actuator::Ranges& ranges) {
  const double torque = ranges.torque_Nm, speed = ranges.speed_rad_s;
  if (ends_with(name, "_Nm_s2_rad2")) return torque / (speed * speed);
  if (ends_with(name, "_Nm_s_rad")) return torque / speed;
  if (ends_with(name, "_Nm_rad")) return torque / ranges.angle_rad;
  if (ends_with(name, "_Nm")) return torque;
  if (ends_with(name, "_kg_m2")) return torque / ranges.acceleration_rad_s2;
  if (ends_with(name, "_rad_s")) return speed;
  if (ends_with(name, "_rad")) return ranges.angle_rad;
  if (ends_with(name, "_A")) return ranges.current_A;
  if (ends_with(name, "_V")) return ranges.voltage_V;
  if (ends_with(name, "_ohm")) return ranges.voltage_V / ranges.current_A;
  if (ends_with(name, "_1_K")) return std::min(0.01, 1.0 / std::max(1.0, ranges.warmth_K));
  if (ends_with(name, "_s")) return 0.01;
  return 1.0;
}

EffectCandidate actuator_candidate(const EffectKind& kind, const actuator::Actuator& stated,
                                   const actuator::Ranges& ranges) {
  EffectCandidate candidate;
  candidate.effect = candidate.key = kind.name;
  candidate.contains.assign(kind.contains.begin(), kind.contains.end());
  candidate.tends_to.assign(kind.tends_to.begin(), kind.tends_to.end());
  std::vector<std::vector<double>> starts = starts_of(kind, ranges);
  const std::vector<double> known = stated_values(kind, stated);
  if (!known.empty()) starts.insert(starts.begin(), known);
  for (std::size_t p = 0; p < kind.parameters.size(); ++p) {
    candidate.parameters.push_back(fit_parameter(kind, ranges, starts, p));
  }
  for (const auto& start : starts) {
    std::vector<double> coordinates;
    for (std::size_t p = 0; p < start.size(); ++p) {
      const FitParameter& parameter = candidate.parameters[p];
      const double base = parameter.above == FitParameter::kNone ? 0.0 : start[parameter.above];
      coordinates.push_back(
          std::clamp(parameter.coordinate(start[p] - base), parameter.lowest, parameter.highest));
    }
    candidate.starts.push_back(std::move(coordinates));
  }
  candidate.apply = [&kind, parameters = candidate.parameters](std::span<const double> coordinates,
                                                               Hypothesis& hypothesis) {
    auto& effects = hypothesis.actuator.effects;
    std::erase_if(effects, [&](const Effect& each) { return takes_place_of(kind, each); });
    effects.push_back(effect_at(kind, parameters, coordinates));
  };
  candidate.report = [&kind,
                      parameters = candidate.parameters](std::span<const double> coordinates) {
    const Effect effect = effect_at(kind, parameters, coordinates);
    FoundParameters found;
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      found.numbers.push_back({parameters[p].name, effect.values[p]});
    }
    return found;
  };
  return candidate;
}

EffectCandidate with_equal_parameters(EffectCandidate candidate) {
  const std::size_t count = candidate.parameters.size();
  double highest = candidate.parameters.front().highest;
  for (const FitParameter& each : candidate.parameters) highest = std::min(highest, each.highest);
  candidate.parameters.resize(1);
  candidate.parameters.front().highest = highest;
  for (auto& start : candidate.starts) start.resize(1);
  candidate.apply = [count, apply = candidate.apply](std::span<const double> u,
                                                     Hypothesis& hypothesis) {
    apply(std::vector<double>(count, u[0]), hypothesis);
  };
  candidate.report = [count, report = candidate.report](std::span<const double> u) {
    return report(std::vector<double>(count, u[0]));
  };
  return candidate;
}

EffectCandidate wave_candidate(const EffectKind& kind, double order, bool proportional,
                               double scale) {
  EffectCandidate candidate;
  candidate.effect = kind.name;
  candidate.key = fmt::format("{}{}:{:g}", kind.name, proportional ? "*load" : "", order);
  candidate.order = order;
  for (const char* part : {"sine", "cosine"}) {
    candidate.parameters.push_back({part, -scale, scale, scale, false});
  }
  candidate.starts = {{0.0, 0.0}};
  const auto wave = [order](std::span<const double> u) {
    return actuator::Harmonic{order, std::hypot(u[0], u[1]), std::atan2(u[1], u[0])};
  };
  candidate.apply = [&kind, proportional, wave](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.actuator.effects.push_back({&kind, {}, {wave(u)}, proportional, "identified"});
  };
  candidate.report = [&kind, order, proportional](std::span<const double> u) {
    FoundParameters found;
    found.waves = {found_wave(order, proportional ? "amplitude_ratio" : "amplitude_Nm", u)};
    if (kind.may_be_proportional) found.proportional = proportional;
    return found;
  };
  return candidate;
}

EffectCandidate imbalance_candidate(const actuator::Ranges& ranges) {
  EffectCandidate candidate;
  candidate.effect = candidate.key = "gravity_imbalance";
  candidate.family = EffectFamily::kRig;
  candidate.order = 1.0;
  const double scale = ranges.torque_Nm;
  for (const char* part : {"sine_Nm", "cosine_Nm"}) {
    candidate.parameters.push_back({part, -scale, scale, scale, false});
  }
  candidate.starts = {{0.0, 0.0}};
  candidate.apply = [](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.imbalance_sine_Nm = u[0];
    hypothesis.imbalance_cosine_Nm = u[1];
  };
  candidate.report = [](std::span<const double> u) {
    FoundParameters found;
    found.numbers = {{"amplitude_Nm", std::hypot(u[0], u[1])},
                     {"phase_rad", std::atan2(u[1], u[0])}};
    return found;
  };
  return candidate;
}

EffectCandidate delay_candidate(Quantity channel) {
  EffectCandidate candidate;
  candidate.effect = "channel_delay";
  candidate.family = EffectFamily::kLog;
  candidate.key = fmt::format("channel_delay:{}", name_of(channel));
  candidate.parameters = {{"delay_s", 0.0, kLongestDelay_s, 0.01, false}};
  candidate.starts = {{0.0}, {0.02}, {0.08}};
  candidate.apply = [channel](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.log.delay_s[static_cast<std::size_t>(channel)] = u[0];
  };
  candidate.report = [channel](std::span<const double> u) {
    FoundParameters found;
    found.channel = name_of(channel);
    found.numbers = {{"delay_s", u[0]}};
    return found;
  };
  return candidate;
}

EffectCandidate offset_candidate(const actuator::Ranges& ranges) {
  EffectCandidate candidate;
  candidate.effect = candidate.key = "torque_offset";
  candidate.family = EffectFamily::kLog;
  const double scale = ranges.torque_Nm;
  candidate.parameters = {{"value", -scale, scale, scale, false}};
  candidate.starts = {{0.0}};
  candidate.apply = [](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.log.torque_offset_Nm = u[0];
  };
  candidate.report = [](std::span<const double> u) {
    FoundParameters found;
    found.numbers = {{"value", u[0]}};
    return found;
  };
  return candidate;
}

EffectCandidate current_gain_candidate() {
  EffectCandidate candidate;
  candidate.effect = candidate.key = "current_gain_error";
  candidate.family = EffectFamily::kLog;
  candidate.parameters = {{"gain_positive", kLeastGain, 1.0 / kLeastGain, 1.0, false},
                          {"gain_negative", kLeastGain, 1.0 / kLeastGain, 1.0, false}};
  candidate.starts = {{1.0, 1.0}};
  for (const EffectKind* each : actuator::effects_standing_for(actuator::StandsFor::kTorqueScale)) {
    candidate.tends_to.emplace_back(each->name);
  }
  candidate.tends_to.emplace_back("torque_offset");
  candidate.apply = [](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.log.positive_current_gain = u[0];
    hypothesis.log.negative_current_gain = u[1];
  };
  candidate.report = [](std::span<const double> u) {
    FoundParameters found;
    found.channel = name_of(Quantity::kMotorCurrent);
    found.numbers = {{"gain_positive", u[0]}, {"gain_negative", u[1]}};
    return found;
  };
  return candidate;
}

EffectCandidate encoder_candidate(std::size_t order, double scale_rad) {
  EffectCandidate candidate;
  candidate.effect = "encoder_harmonics";
  candidate.family = EffectFamily::kLog;
  candidate.key = fmt::format("{}:{}", candidate.effect, order);
  candidate.order = static_cast<double>(order);
  for (const char* part : {"sine_rad", "cosine_rad"}) {
    candidate.parameters.push_back({part, -scale_rad, scale_rad, scale_rad, false});
  }
  candidate.starts = {{0.0, 0.0}};
  candidate.apply = [order](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.log.encoder_sine_rad[order - 1] = u[0];
    hypothesis.log.encoder_cosine_rad[order - 1] = u[1];
  };
  candidate.report = [order](std::span<const double> u) {
    FoundParameters found;
    found.channel = name_of(Quantity::kOutputPosition);
    found.waves = {found_wave(static_cast<double>(order), "amplitude_rad", u)};
    return found;
  };
  return candidate;
}

}  // namespace torquewright::identification
