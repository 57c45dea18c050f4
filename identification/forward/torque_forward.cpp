// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/torque_forward.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "actuator/effects/library.hpp"
#include "identification/forward/backlash_residual.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/forward/pushing_friction.hpp"
#include "identification/forward/sample_step.hpp"
#include "identification/forward/torque_prediction.hpp"
#include "identification/forward/wave_orders.hpp"
#include "identification/preparation/balance.hpp"
#include "identification/preparation/uncertain.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::EffectKind;
using actuator::StandsFor;
using actuator::TrainPart;

/// Samples of series that are remembered of each kind, and bounds of the number of series: of a
/// short log twice as many as a model has effects, of a long one one, whose size is the log's.
constexpr std::size_t kRememberedSamples = 1'000'000;
constexpr std::size_t kFewestSeries = 1, kMostSeries = 24;
constexpr double kMostFactor = 30.0;  ///< An uncertain value is within it of what is stated.

bool is_uncertain(const Bench& bench, const char* pointer) {
  const auto& list = bench.rig->uncertain;
  return std::find(list.begin(), list.end(), pointer) != list.end();
}

/// Whether a value that looks like it is fitted in its place.
bool is_fitted_as_a_value(const Bench& bench, const EffectKind& kind) {
  switch (kind.stands_for) {
    case StandsFor::kTorqueScale:
      return is_uncertain(bench, "/motor/torque_constant_Nm_A");
    case StandsFor::kLoadInertia:
      return is_uncertain(bench, "/motor/rotor_inertia_kg_m2") ||
             is_uncertain(bench, "/load/inertia_kg_m2");
    default:
      return false;
  }
}

/// Whether a torque balance of such a bench can hold the effect.
bool can_enter(const Bench& bench, const EffectKind& kind) {
  const actuator::Needs& needs = kind.needs;
  if (needs.winding_temperature && !bench.has_temperature) return false;
  if (needs.winding_voltage && bench.drive != Drive::kVoltage) return false;
  if (needs.duty && bench.drive_channel != Quantity::kDuty) return false;
  if (kind.in_train == TrainPart::kGap) return shows_backlash(bench);
  return kind.in_train == TrainPart::kNone && !is_fitted_as_a_value(bench, kind);
}

/// An angle of the base: either way from 0.
bool is_angle(const std::string& pointer) { return pointer.ends_with("_rad"); }

void add_uncertain(const Bench& bench, const actuator::Ranges& ranges, ForwardEquation& equation) {
  for (const std::string& pointer : bench.rig->uncertain) {
    const double* value = value_at(pointer, equation.stated.rig, equation.stated.actuator);
    if (value == nullptr) continue;
    if (is_of_load(pointer) && bench.load_side != LoadSide::kModel) continue;
    if (pointer == "/motor/resistance_ohm" && bench.drive != Drive::kVoltage) continue;
    const double size = *value != 0.0 ? std::abs(*value) : size_of(pointer, ranges);
    FitParameter parameter{pointer, *value - kMostFactor * size, *value + kMostFactor * size, size,
                           false};
    // No mass, inertia, constant or ratio changes its sign.
    if (*value > 0.0) parameter.lowest = size / kMostFactor;
    if (*value < 0.0) parameter.highest = -size / kMostFactor;
    if (*value == 0.0 && !is_angle(pointer)) parameter.lowest = 0.0;
    equation.always.push_back(parameter);
    equation.always_start.push_back(*value);
    equation.pointers.push_back(pointer);
  }
  equation.apply_always = [pointers = equation.pointers](std::span<const double> values,
                                                         Hypothesis& hypothesis) {
    for (std::size_t k = 0; k < pointers.size(); ++k) {
      *value_at(pointers[k], hypothesis.rig, hypothesis.actuator) = values[k];
    }
  };
}

/// What is late is so from the middle of a step: the instant is not fitted beside it.
EffectCandidate from_mid_step(EffectCandidate candidate) {
  candidate.apply = [before = candidate.apply](std::span<const double> values,
                                               Hypothesis& hypothesis) {
    before(values, hypothesis);
    hypothesis.log.instant_s = 0.0;
  };
  return candidate;
}

void add_delays(const Bench& bench, std::vector<EffectCandidate>& candidates) {
  if (bench.is_drive_by_law()) return;
  const auto add = [&](Quantity channel) {
    candidates.push_back(from_mid_step(delay_candidate(channel)));
  };
  add(bench.drive_channel);
  if (bench.load_side == LoadSide::kSensor) add(bench.load_channel);
  if (bench.is_linear) return add(Quantity::kLinearPosition);
  add(bench.encoders == Encoders::kMotor ? Quantity::kMotorPosition : Quantity::kOutputPosition);
}

/// Where the torque constant is open, so is what torques are compared with.
void widen_torques(EffectCandidate& candidate) {
  for (FitParameter& each : candidate.parameters) {
    const bool is_torque = candidate.order > 0.0 || each.name.find("_Nm") != std::string::npos;
    if (!is_torque || each.is_scale || each.size == 1.0) continue;
    each.lowest *= kMostFactor;
    each.highest *= kMostFactor;
  }
}

std::vector<EffectCandidate> waves_of(const Bench& bench, const WaveOrders& orders,
                                      const actuator::Ranges& ranges) {
  std::vector<EffectCandidate> waves;
  const double ratio = std::abs(bench.actuator().transmission.ratio);
  const auto is_cogging_too = [&](double order) {
    return ratio == std::floor(ratio) &&
           std::any_of(orders.motor.begin(), orders.motor.end(),
                       [&](double each) { return each * ratio == order; });
  };
  const double torque_Nm = ranges.torque_Nm;
  const EffectKind& of_motor = actuator::first_wave(Acts::kMotorSideTorque);
  const EffectKind& of_output = actuator::first_wave(Acts::kOutputTorque);
  const EffectKind& of_friction = actuator::first_wave(Acts::kDrag);
  for (const double order : orders.motor) {
    waves.push_back(wave_candidate(of_motor, order, false, torque_Nm));
  }
  for (const double order : orders.output) {
    if (order == 1.0 || is_cogging_too(order)) continue;
    waves.push_back(wave_candidate(of_output, order, false, torque_Nm));
  }
  for (const double order : orders.load) {
    waves.push_back(wave_candidate(of_output, order, true, 1.0));
  }
  for (const double order : orders.friction) {
    waves.push_back(wave_candidate(of_friction, order, false, torque_Nm));
  }
  if (is_uncertain(bench, "/motor/torque_constant_Nm_A")) {
    std::for_each(waves.begin(), waves.end(), widen_torques);
  }
  return waves;
}

/// The balance's measured side, in its unit.
std::vector<double> measured_of(const Bench& bench, const Signals& signals) {
  if (bench.load_side == LoadSide::kSensor) return signals.load_side_Nm;
  if (bench.drive == Drive::kVoltage) return signals.voltage_V;
  if (bench.drive == Drive::kTorque) return signals.motor_side_Nm;
  std::vector<double> current_A;
  for (const actuator::Instant& at : signals.at) current_A.push_back(at.current_A);
  return current_A;
}

/// Of the motor's side or the load's, whichever is more.
double used_torque_Nm(const std::vector<Signals>& signals) {
  double square = 0.0, count = 0.0;
  for (const Signals& stretch : signals) {
    for (std::size_t i = 0; i < stretch.size(); ++i) {
      if (stretch.usable[i] == 0) continue;
      const double load_Nm = stretch.load_side_Nm.empty() ? 0.0 : stretch.load_side_Nm[i];
      square += std::max(stretch.motor_side_Nm[i] * stretch.motor_side_Nm[i], load_Nm * load_Nm);
      ++count;
    }
  }
  return count > 0.0 ? std::sqrt(square / count) : 0.0;
}

/// The balances of stretches, each of which remembers as many series as memory has room for.
ResidualOfStretch balances_on(const Bench& bench, const std::vector<Signals>& signals) {
  std::size_t samples = 1;
  for (const Signals& each : signals) samples += each.size();
  const std::size_t series = std::clamp(kRememberedSamples / samples, kFewestSeries, kMostSeries);
  auto balances = std::make_shared<std::vector<TorqueBalance>>();
  for (const Signals& each : signals) balances->emplace_back(bench, each, series);
  return [balances](const Hypothesis& hypothesis, std::size_t stretch) {
    return (*balances)[stretch].residual_Nm(hypothesis);
  };
}

/// Whether the effect shows in what follows in time.
bool needs_time(const EffectCandidate& candidate) {
  const EffectKind* kind = actuator::find_effect(candidate.effect);
  return candidate.effect == "channel_delay" ||
         (kind != nullptr && (kind->state_rate != nullptr || kind->acts == Acts::kInertialTorque));
}

/// Whether the angle of the output, or how far it turned, is in the log: of steady states only
/// where it was measured.
bool shows_angle(const Bench& bench, const std::vector<Signals>& signals) {
  return !bench.rig->load.is_steady ||
         std::any_of(signals.begin(), signals.end(), [](const Signals& each) {
           return std::any_of(each.at.begin(), each.at.end(), [&](const actuator::Instant& at) {
             return at.output_angle_rad != each.at.front().output_angle_rad;
           });
         });
}

/// Whether the effect is a law of the output's or the rotor's angle.
bool needs_angle(const EffectCandidate& candidate) {
  const EffectKind* kind = actuator::find_effect(candidate.effect);
  return candidate.order > 0.0 ||
         (kind != nullptr && (kind->acts == Acts::kOutputTorque ||
                              kind->acts == Acts::kMotorSideTorque || kind->has_harmonics));
}

/// Whether something is later than stated by less than the log can hold: at which instant of its
/// step a sample was taken no log says.
bool is_late_by_less(const Hypothesis& hypothesis, const actuator::Actuator& stated,
                     double least_s) {
  const auto is_less = [&](double late_s) { return late_s > 0.0 && late_s < least_s; };
  const auto& delays_s = hypothesis.log.delay_s;
  if (std::any_of(delays_s.begin(), delays_s.end(), is_less)) return true;
  const auto is_lag = [](const actuator::Effect& each) { return each.kind->follows_torque; };
  if (std::any_of(stated.effects.begin(), stated.effects.end(), is_lag)) return false;
  return std::any_of(
      hypothesis.actuator.effects.begin(), hypothesis.actuator.effects.end(),
      [&](const actuator::Effect& each) { return is_lag(each) && is_less(each.values[0]); });
}

/// L/R of a winding that is known by its voltage. The instant of the step moves the voltage alone,
/// this the current that it drives; from half a step on it is a lag of the torque.
void add_winding_lag(double half_a_step_s, ForwardEquation& equation) {
  if (half_a_step_s == 0.0) return;
  const std::size_t index = equation.always.size();
  equation.always.push_back({"lag of the winding", 0.0, half_a_step_s, half_a_step_s, false});
  equation.always_start.push_back(0.0);
  equation.apply_always = [index, before = equation.apply_always](std::span<const double> values,
                                                                  Hypothesis& hypothesis) {
    before(values, hypothesis);
    hypothesis.winding_late_s = values[index];
  };
}

}  // namespace

std::vector<EffectCandidate> torque_candidates(const Bench& bench, const actuator::Ranges& ranges) {
  std::vector<EffectCandidate> candidates;
  for (const EffectKind* each : actuator::effect_library()) {
    if (each->has_harmonics || !can_enter(bench, *each)) continue;
    candidates.push_back(actuator_candidate(*each, bench.actuator(), ranges));
    if (each->follows_torque) candidates.back() = from_mid_step(std::move(candidates.back()));
    // Driving less back-driving load friction is the load itself: beside an open torque constant
    // the sum of the two coefficients is all that a log can hold.
    if (each->acts == Acts::kLoadFriction && is_uncertain(bench, "/motor/torque_constant_Nm_A")) {
      candidates.back() = with_equal_parameters(std::move(candidates.back()));
    }
  }
  if (ranges.angle_rad >= std::numbers::pi / 2.0) {
    candidates.push_back(imbalance_candidate(ranges));
  }
  candidates.push_back(offset_candidate(ranges));
  if (is_uncertain(bench, "/motor/torque_constant_Nm_A")) {
    std::for_each(candidates.begin(), candidates.end(), widen_torques);
  }
  add_delays(bench, candidates);
  if (bench.drive == Drive::kCurrent && !is_uncertain(bench, "/motor/torque_constant_Nm_A"))
    candidates.push_back(current_gain_candidate());
  return candidates;
}

ForwardEquation torque_forward(const Bench& bench, const std::vector<Signals>& signals,
                               const std::vector<std::size_t>& fold_of_run) {
  const Balance balance(bench);
  ForwardEquation equation;
  equation.quantity = name_of(balance.quantity());
  equation.unit = unit_of(balance.quantity());
  if (balance.quantity() == Quantity::kWindingVoltage) equation.unit = "V";
  equation.unit_per_residual = balance.unit_per_Nm();
  equation.stated.actuator = bench.actuator();
  equation.stated.rig = *bench.rig;
  equation.is_torque_balance = true;
  equation.target_is_drive = bench.load_side == LoadSide::kModel;
  equation.used = used_torque_Nm(signals);
  const actuator::Ranges ranges = ranges_of(bench, signals);
  add_uncertain(bench, ranges, equation);
  if (!bench.is_drive_by_law())
    add_instant(half_a_step_s(signals), &LogErrors::instant_s, equation);
  if (bench.drive == Drive::kVoltage) add_winding_lag(half_a_step_s(signals), equation);
  equation.candidates = torque_candidates(bench, ranges);
  equation.residual = [&bench](const Hypothesis& hypothesis, const Signals& stretch) {
    return torque_balance_Nm(bench, hypothesis, stretch);
  };
  equation.residual_on = [&bench](const std::vector<Signals>& stretches) {
    return balances_on(bench, stretches);
  };
  equation.measured = [&bench](const Signals& stretch) { return measured_of(bench, stretch); };
  equation.is_possible = [&bench, speed_rad_s = ranges.speed_rad_s,
                          least_s = half_a_step_s(signals)](const Hypothesis& hypothesis) {
    return !friction_pushes(hypothesis.actuator, speed_rad_s) &&
           !is_late_by_less(hypothesis, bench.actuator(), least_s);
  };
  const bool is_map = std::none_of(signals.begin(), signals.end(),
                                   [](const Signals& each) { return each.step_s > 0.0; });
  if (is_map) std::erase_if(equation.candidates, needs_time);
  const bool has_angle = shows_angle(bench, signals);
  if (!has_angle) std::erase_if(equation.candidates, needs_angle);
  equation.waves = [&bench, &signals, fold_of_run, ranges, has_angle](const auto& left) {
    if (!has_angle) return std::vector<EffectCandidate>();
    return waves_of(bench, promising_waves(bench, left, signals, fold_of_run, ranges), ranges);
  };
  return equation;
}

}  // namespace torquewright::identification
