// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/plain_forward.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "actuator/effects/acting.hpp"
#include "actuator/effects/library.hpp"
#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "identification/forward/candidates.hpp"
#include "identification/forward/sample_step.hpp"
#include "identification/forward/twist_under_load.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::EffectKind;
using actuator::Instant;

constexpr double kMostMismatch = 10.0;  ///< Of a velocity's scale, to either side of one.
constexpr double kWholeTurn_rad = 2.0 * std::numbers::pi;
constexpr double kMostEncoderError_rad = 0.3;
constexpr double kLongestWinding_s = 0.02;  ///< Inductance over resistance.
constexpr const char* kResistance = "/motor/resistance_ohm";

bool has(const std::vector<Signals>& signals, std::vector<double> Signals::*channel) {
  return !signals.empty() && !(signals.front().*channel).empty();
}

double rms_of(const std::vector<Signals>& signals, std::vector<double> Signals::*channel) {
  double square = 0.0, count = 0.0;
  for (const Signals& stretch : signals) {
    for (const double value : stretch.*channel) square += value * value;
    count += static_cast<double>((stretch.*channel).size());
  }
  return count > 0.0 ? std::sqrt(square / count) : 0.0;
}

ForwardEquation equation_of(const Bench& bench, std::string quantity, std::string unit) {
  ForwardEquation equation;
  equation.quantity = std::move(quantity);
  equation.unit = std::move(unit);
  equation.stated.actuator = bench.actuator();
  equation.stated.rig = *bench.rig;
  equation.apply_always = [](std::span<const double>, Hypothesis&) {};
  return equation;
}

/// A number of the log that every model fits.
void add_zero(ForwardEquation& equation, double LogErrors::*zero, const std::string& name,
              double size) {
  equation.always.push_back({name, -1e3 * size, 1e3 * size, size, false});
  equation.always_start.push_back(0.0);
  const std::size_t index = equation.always.size() - 1;
  equation.apply_always = [zero, index, before = equation.apply_always](
                              std::span<const double> values, Hypothesis& hypothesis) {
    before(values, hypothesis);
    hypothesis.log.*zero = values[index];
  };
}

/// Every effect of the library of which the claim holds.
template <typename Claim>
void add_effects(const Bench& bench, const actuator::Ranges& ranges, const Claim& claim,
                 ForwardEquation& equation) {
  for (const actuator::EffectKind* each : actuator::effect_library()) {
    if (!claim(*each)) continue;
    equation.candidates.push_back(actuator_candidate(*each, bench.actuator(), ranges));
  }
}

void add_effects_that_act(actuator::Acts acts, const Bench& bench, const actuator::Ranges& ranges,
                          ForwardEquation& equation) {
  add_effects(
      bench, ranges, [acts](const EffectKind& kind) { return kind.acts == acts; }, equation);
}

double encoder_error_rad(const LogErrors& log, double angle_rad) {
  double sum = 0.0;
  for (std::size_t k = 0; k < log.encoder_sine_rad.size(); ++k) {
    const double turned = static_cast<double>(k + 1) * angle_rad;
    sum +=
        log.encoder_sine_rad[k] * std::sin(turned) + log.encoder_cosine_rad[k] * std::cos(turned);
  }
  return sum;
}

ForwardEquation twist_forward(const Bench& bench, const actuator::Ranges& ranges) {
  ForwardEquation equation = equation_of(bench, "motor_position_rad", "rad");
  add_zero(equation, &LogErrors::encoder_zero_rad, "zero of the encoders", ranges.angle_rad);
  add_effects(
      bench, ranges,
      [](const EffectKind& kind) { return kind.in_train != actuator::TrainPart::kNone; }, equation);
  const Quantity output = bench.is_linear ? Quantity::kLinearPosition : Quantity::kOutputPosition;
  equation.candidates.push_back(delay_candidate(Quantity::kMotorPosition));
  equation.candidates.push_back(delay_candidate(output));
  // Over less than a turn a wave is too much like what a load that hangs does to a spring.
  for (std::size_t order = 1; order <= 2 && ranges.angle_rad >= kWholeTurn_rad; ++order) {
    equation.candidates.push_back(encoder_candidate(order, kMostEncoderError_rad));
  }
  equation.measured = [](const Signals& signals) { return signals.twist_rad; };
  equation.residual = [output](const Hypothesis& supposed, const Signals& signals) {
    const auto delay_s = [&](Quantity q) {
      return supposed.log.delay_s[static_cast<std::size_t>(q)];
    };
    // To first order: a channel that is late lags by its delay times the speed.
    const double late_s = delay_s(Quantity::kMotorPosition) - delay_s(output);
    const std::vector<double> twist_rad = twist_under_load_rad(supposed.actuator, signals.at);
    std::vector<double> left(signals.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      left[i] = signals.twist_rad[i] - supposed.log.encoder_zero_rad - twist_rad[i] +
                late_s * signals.at[i].speed_rad_s +
                encoder_error_rad(supposed.log, signals.at[i].output_angle_rad);
    }
    return left;
  };
  return equation;
}

/// What the bridge adds, over both signs of the current by their shares of a sample's time.
double bridge_V(const actuator::Actuator& actuator, Instant at, double sign) {
  const double size_A = std::abs(at.current_A);
  at.current_A = size_A;
  const double forward_V = actuator::winding_voltage_change_V(actuator, at);
  at.current_A = -size_A;
  const double backward_V = actuator::winding_voltage_change_V(actuator, at);
  return 0.5 * ((1.0 + sign) * forward_V + (1.0 - sign) * backward_V);
}

double current_sign(const Signals& signals, std::size_t i) {
  if (!signals.filtered_current_sign.empty()) return signals.filtered_current_sign[i];
  const double current_A = signals.at[i].current_A;
  return current_A > 0.0 ? 1.0 : current_A < 0.0 ? -1.0 : 0.0;
}

/// A number that every model fits, for documents state it of a phase, roughly, or not at all.
void add_inductance(const Bench& bench, ForwardEquation& equation) {
  const double most_H = kLongestWinding_s * actuator::winding_of(bench.actuator()).resistance_ohm;
  equation.always.push_back({"inductance of the winding", 0.0, most_H, 0.1 * most_H, false});
  equation.always_start.push_back(0.0);
  const std::size_t index = equation.always.size() - 1;
  equation.apply_always = [index, before = equation.apply_always](std::span<const double> values,
                                                                  Hypothesis& hypothesis) {
    before(values, hypothesis);
    hypothesis.winding_inductance_H = values[index];
  };
}

/// V - R i - L di/dt - Ke N w - what the bridge keeps.
std::vector<double> voltage_left_V(const Hypothesis& supposed, const Signals& signals) {
  const actuator::Actuator& actuator = supposed.actuator;
  const actuator::Winding winding = actuator::winding_of(actuator);
  const double ratio = actuator.transmission.ratio;
  std::vector<double> left(signals.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    const Instant& at = signals.at[i];
    left[i] =
        signals.voltage_V[i] + bridge_V(actuator, at, current_sign(signals, i)) -
        winding.back_emf_V_s_rad * actuator::flux_factor(actuator, at) * ratio * at.speed_rad_s -
        actuator::resistance_ohm(actuator, winding, at) * at.current_A;
    if (signals.current_rate_A_s.empty()) continue;
    left[i] -= supposed.winding_inductance_H * signals.current_rate_A_s[i];
  }
  return left;
}

ForwardEquation voltage_forward(const Bench& bench, const std::vector<Signals>& signals,
                                const actuator::Ranges& ranges) {
  ForwardEquation equation = equation_of(bench, "winding_voltage_V", "V");
  const auto& uncertain = bench.rig->uncertain;
  if (std::find(uncertain.begin(), uncertain.end(), kResistance) != uncertain.end()) {
    const double stated = bench.actuator().motor.resistance_ohm;
    equation.always.push_back({kResistance, stated / 30.0, stated * 30.0, stated, false});
    equation.always_start.push_back(stated);
    equation.pointers.push_back(kResistance);
    equation.apply_always = [](std::span<const double> values, Hypothesis& hypothesis) {
      hypothesis.actuator.motor.resistance_ohm = values[0];
    };
  }
  if (has(signals, &Signals::current_rate_A_s)) add_inductance(bench, equation);
  if (!bench.actuator().motor.back_emf_constant_V_s_rad) {
    add_effects(
        bench, ranges,
        [](const EffectKind& kind) { return kind.stands_for == actuator::StandsFor::kTorqueScale; },
        equation);
  }
  if (bench.has_temperature) {
    add_effects_that_act(Acts::kResistanceFactor, bench, ranges, equation);
  }
  add_effects_that_act(Acts::kWindingVoltage, bench, ranges, equation);
  equation.measured = [](const Signals& stretch) { return stretch.voltage_V; };
  equation.residual = voltage_left_V;
  return equation;
}

ForwardEquation bus_forward(const Bench& bench, const actuator::Ranges& ranges) {
  ForwardEquation equation = equation_of(bench, "bus_voltage_V", "V");
  // What the supply has without load is known to its charge only.
  add_zero(equation, &LogErrors::open_circuit_V, "open circuit", ranges.voltage_V);
  add_effects_that_act(Acts::kBusVoltage, bench, ranges, equation);
  equation.measured = [](const Signals& signals) { return signals.bus_V; };
  equation.residual = [](const Hypothesis& supposed, const Signals& signals) {
    std::vector<double> left(signals.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      Instant at = signals.at[i];
      at.bus_current_A = signals.bus_A[i];
      left[i] = signals.bus_V[i] - supposed.actuator.drive.bus_voltage_V -
                supposed.log.open_circuit_V - actuator::bus_voltage_change_V(supposed.actuator, at);
    }
    return left;
  };
  return equation;
}

EffectCandidate velocity_mismatch() {
  EffectCandidate candidate;
  candidate.effect = candidate.key = "velocity_mismatch";
  candidate.family = EffectFamily::kLog;
  candidate.parameters = {{"scale", -kMostMismatch, kMostMismatch, 1.0, false},
                          {"delay_s", -0.2, 0.2, 0.01, false}};
  candidate.starts = {{1.0, 0.0}};
  candidate.apply = [](std::span<const double> u, Hypothesis& hypothesis) {
    hypothesis.log.velocity_scale = u[0];
    hypothesis.log.velocity_delay_s = u[1];
  };
  candidate.report = [](std::span<const double> u) {
    FoundParameters found;
    found.numbers = {{"scale", u[0]}, {"delay_s", u[1]}};
    return found;
  };
  return candidate;
}

/// A logged velocity less that of the position, which turns `ratio` times as fast.
ForwardEquation velocity_forward(const Bench& bench, std::string quantity, std::string unit,
                                 std::vector<double> Signals::*logged, double ratio,
                                 double half_a_step_s) {
  ForwardEquation equation = equation_of(bench, std::move(quantity), std::move(unit));
  add_instant(half_a_step_s, &LogErrors::velocity_delay_s, equation);
  equation.candidates.push_back(velocity_mismatch());
  equation.measured = [logged](const Signals& signals) { return signals.*logged; };
  equation.residual = [logged, ratio](const Hypothesis& supposed, const Signals& signals) {
    std::vector<double> speed(signals.size());
    for (std::size_t i = 0; i < speed.size(); ++i) speed[i] = ratio * signals.at[i].speed_rad_s;
    if (supposed.log.velocity_delay_s != 0.0) {
      speed = advanced(speed, -supposed.log.velocity_delay_s, signals.step_s);
    }
    for (std::size_t i = 0; i < speed.size(); ++i) {
      speed[i] = (signals.*logged)[i] - supposed.log.velocity_scale * speed[i];
    }
    return speed;
  };
  return equation;
}

}  // namespace

std::vector<ForwardEquation> plain_forward(const Bench& bench,
                                           const std::vector<Signals>& signals) {
  const actuator::Ranges ranges = ranges_of(bench, signals);
  std::vector<ForwardEquation> equations;
  if (has(signals, &Signals::twist_rad)) equations.push_back(twist_forward(bench, ranges));
  if (bench.drive == Drive::kCurrent && has(signals, &Signals::voltage_V)) {
    equations.push_back(voltage_forward(bench, signals, ranges));
    equations.back().used = rms_of(signals, &Signals::voltage_V);
  }
  if (has(signals, &Signals::bus_V) && has(signals, &Signals::bus_A)) {
    equations.push_back(bus_forward(bench, ranges));
  }
  const auto add_velocity = [&](const char* quantity, const char* unit,
                                std::vector<double> Signals::*logged, double ratio) {
    if (!has(signals, logged)) return;
    equations.push_back(
        velocity_forward(bench, quantity, unit, logged, ratio, half_a_step_s(signals)));
    equations.back().used = rms_of(signals, logged);
  };
  if (bench.is_linear) {
    add_velocity("linear_velocity_m_s", "m/s", &Signals::logged_velocity_rad_s, 1.0);
  } else {
    add_velocity("output_velocity_rad_s", "rad/s", &Signals::logged_velocity_rad_s, 1.0);
  }
  add_velocity("motor_velocity_rad_s", "rad/s", &Signals::motor_velocity_rad_s,
               bench.actuator().transmission.ratio);
  return equations;
}

}  // namespace torquewright::identification
