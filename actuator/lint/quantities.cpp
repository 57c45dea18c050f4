// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "actuator/motor/statement.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kOfEachStage = 0.9;    // least efficiency of one stage of gears
constexpr double kRatioOfStage = 10.0;  // greatest of one planetary stage
constexpr const char* kTorqueConstant = "/motor/torque_constant_Nm_A";
constexpr const char* kConvention = "/motor/torque_constant_convention";

CurrentConvention convention(const Actuator& document) {
  return document.motor.torque_constant_convention;
}

/// Where a data sheet of the motor, or none, is read: 1.
bool is_of_joint(const Actuator& document, const char* name) {
  return document.datasheet && is_at_joint(document, std::string("/datasheet/") + name);
}

/// Amperes of the torque constant, over `current_factor`, per printed ampere.
double amperes_per_printed(const Interpretation& interpretation, const char* pointer) {
  const Statement* statement = find_statement(interpretation.document, pointer);
  if (statement == nullptr || !statement->ampere) return 1.0;
  return phase_amperes_per_ampere(*statement->ampere) /
         (phase_amperes_per_ampere(convention(interpretation.document)) *
          interpretation.current_factor);
}

/// An efficiency of exactly 1, or one that is marked as assumed, is not known.
bool is_efficiency_known(const Actuator& document) {
  const bool is_assumed =
      std::any_of(document.assumed.begin(), document.assumed.end(), [](const auto& pointer) {
        return pointer == "/gearbox" || pointer == "/gearbox/forward_efficiency";
      });
  return !is_assumed && document.transmission.forward_efficiency != 1.0;
}

RoundedInterval gear_efficiency(const Actuator& document) {
  const Transmission& gear = document.transmission;
  if (!gear.source.empty()) return exact(gear.forward_efficiency, "/gearbox/file");
  return efficiency(gear.forward_efficiency, "/gearbox/forward_efficiency");
}

bool is_stated_at_joint(const Actuator& document, const char* pointer) {
  const Statement* statement = find_statement(document, pointer);
  return statement != nullptr && statement->at_joint.value_or(false);
}

RoundedInterval printed_torque_constant(const Actuator& document) {
  return printed(document, document.motor.torque_constant_Nm_A, kTorqueConstant);
}

/// From one that is stated at the joint: the gears' losses are in it, or are not, or are unknown.
RoundedInterval torque_constant_at_motor(const Actuator& document, const RoundedInterval& joint) {
  RoundedInterval gears = gear_efficiency(document);
  gears.low *= least_share_of_gears(document);
  return derive([](double constant_Nm_A, double turns,
                   double efficiency) { return constant_Nm_A / (turns * efficiency); },
                joint, ratio(document), gears);
}

}  // namespace

double least_share_of_gears(const Actuator& document) {
  const double ratio = std::abs(document.transmission.ratio);
  if (ratio == 1.0 || is_efficiency_known(document)) return 1.0;
  const double stages = std::ceil(std::log(std::max(ratio, 1.0 / ratio)) / std::log(kRatioOfStage));
  return std::min(1.0, std::pow(kOfEachStage, stages) /
                           std::min(1.0, document.transmission.forward_efficiency));
}

RoundedInterval printed(const Actuator& document, double value, const char* pointer) {
  const Statement* statement = find_statement(document, pointer);
  if (statement == nullptr) return rounded(value, pointer);
  if (!statement->tolerance && !statement->bound) return rounded(statement->printed, pointer);
  RoundedInterval interval = exact(statement->printed, pointer);
  interval.low *= 1.0 - statement->tolerance.value_or(0.0);
  interval.high *= 1.0 + statement->tolerance.value_or(0.0);
  if (statement->bound == Bound::kAtLeast) interval.high = kUnlimited;
  if (statement->bound == Bound::kAtMost) interval.low = 0.0;
  return interval;
}

double product(double one, double other) { return one * other; }

std::optional<RoundedInterval> sheet_number(const Actuator& document, SheetKey key,
                                            const char* name) {
  if (!document.datasheet || !(*document.datasheet.*key)) return std::nullopt;
  const std::string pointer = std::string("/datasheet/") + name;
  return printed(document, *(*document.datasheet.*key), pointer.c_str());
}

std::optional<RoundedInterval> sheet_condition(const Actuator& document, SheetKey key,
                                               const char* name) {
  if (!document.datasheet || !(*document.datasheet.*key)) return std::nullopt;
  const std::string pointer = std::string("/datasheet/") + name;
  return condition(document, *(*document.datasheet.*key), pointer.c_str());
}

RoundedInterval condition(const Actuator& document, double value, const char* pointer) {
  const Statement* statement = find_statement(document, pointer);
  const bool is_open = statement != nullptr && (statement->tolerance || statement->bound);
  if (is_open) return printed(document, value, pointer);
  return exact(statement != nullptr ? statement->printed : value, pointer);
}

RoundedInterval ratio(const Actuator& document) {
  const double magnitude = std::abs(document.transmission.ratio);
  const bool has_teeth = !document.transmission.source.empty();
  if (has_teeth) return exact(magnitude, "/gearbox/file");
  return magnitude == std::round(magnitude) ? exact(magnitude, "/gearbox/ratio")
                                            : rounded(magnitude, "/gearbox/ratio");
}

RoundedInterval sheet_ratio(const Actuator& document, const char* name) {
  return is_of_joint(document, name) ? ratio(document) : exact(1.0);
}

RoundedInterval efficiency(double value, const char* pointer) {
  if (value == 0.0 || value == 1.0) return exact(value, pointer);
  RoundedInterval interval = rounded(value, pointer);
  interval.high = std::min(interval.high, 1.0);
  return interval;
}

RoundedInterval sheet_efficiency(const Actuator& document, const char* name) {
  return is_of_joint(document, name) ? gear_efficiency(document) : exact(1.0);
}

RoundedInterval torque_constant(const Actuator& document) {
  const RoundedInterval constant = printed_torque_constant(document);
  return is_stated_at_joint(document, kTorqueConstant)
             ? torque_constant_at_motor(document, constant)
             : constant;
}

RoundedInterval sheet_torque_constant(const Actuator& document, const char* name) {
  if (is_stated_at_joint(document, kTorqueConstant) && is_of_joint(document, name)) {
    return printed_torque_constant(document);
  }
  return derive([](double efficiency, double turns,
                   double constant_Nm_A) { return efficiency * turns * constant_Nm_A; },
                sheet_efficiency(document, name), sheet_ratio(document, name),
                torque_constant(document));
}

RoundedInterval phase_torque_constant(const Actuator& document) {
  const double per_ampere = phase_amperes_per_ampere(convention(document));
  return derive(product, torque_constant(document), exact(1.0 / per_ampere, kConvention));
}

std::optional<RoundedInterval> stated_back_emf(const Actuator& document) {
  constexpr const char* kPointer = "/motor/back_emf_constant_V_s_rad";
  const std::optional<double>& constant = document.motor.back_emf_constant_V_s_rad;
  if (!constant) return std::nullopt;
  const RoundedInterval stated = printed(document, *constant, kPointer);
  if (!is_stated_at_joint(document, kPointer)) return stated;
  return derive([](double volts, double turns) { return volts / turns; }, stated, ratio(document));
}

RoundedInterval phase_back_emf(const Interpretation& interpretation) {
  const std::optional<RoundedInterval> stated = stated_back_emf(interpretation.document);
  if (stated) {
    return derive(product, *stated,
                  exact(1.0 / volts_per_phase_volt(interpretation.emf_measure), kConvention));
  }
  // Without losses, electrical power 1.5 Ke w i is mechanical power Kt i w.
  return derive(product, phase_torque_constant(interpretation.document), exact(2.0 / 3.0));
}

RoundedInterval phase_resistance(const Actuator& document) {
  const double factor = phase_ohms_per_ohm(document.motor.resistance_convention);
  return derive(product, printed(document, document.motor.resistance_ohm, "/motor/resistance_ohm"),
                exact(factor, "/motor/resistance_convention"));
}

RoundedInterval phase_voltage(const Actuator& document) {
  const RoundedInterval bus_V =
      sheet_condition(document, &Datasheet::voltage_V, "voltage_V")
          .value_or(exact(document.drive.bus_voltage_V, "/drive/bus_voltage_V"));
  const double per_bus_volt =
      phase_volts_per_bus_volt(convention(document), document.drive.modulation);
  RoundedInterval factor = exact(per_bus_volt, kConvention);
  if (convention(document) != CurrentConvention::kDc) {
    factor.pointers.push_back("/drive/modulation");
  }
  return derive(product, bus_V, factor);
}

RoundedInterval torque_constant_amperes(const Interpretation& interpretation,
                                        const RoundedInterval& current_A, const char* pointer) {
  const double factor = amperes_per_printed(interpretation, pointer);
  return factor == 1.0 ? current_A : derive(product, current_A, exact(factor, kConvention));
}

RoundedInterval printed_amperes(const Interpretation& interpretation,
                                const RoundedInterval& current_A, const char* pointer) {
  const double factor = 1.0 / amperes_per_printed(interpretation, pointer);
  return factor == 1.0 ? current_A : derive(product, current_A, exact(factor, kConvention));
}

RoundedInterval phase_current(const Interpretation& interpretation,
                              const RoundedInterval& current_A) {
  const double factor =
      interpretation.current_factor * phase_amperes_per_ampere(convention(interpretation.document));
  return derive(product, current_A, exact(factor, kConvention));
}

RoundedInterval peak_current(const Interpretation& interpretation) {
  constexpr const char* kPointer = "/drive/peak_current_A";
  const Actuator& document = interpretation.document;
  return torque_constant_amperes(
      interpretation, condition(document, document.drive.peak_current_A, kPointer), kPointer);
}

RoundedInterval demagnetisation_current(const Interpretation& interpretation) {
  constexpr const char* kPointer = "/motor/demagnetisation_current_A";
  const Actuator& document = interpretation.document;
  if (document.motor.demagnetisation_current_A == kUnlimited) return exact(kUnlimited, kPointer);
  return torque_constant_amperes(
      interpretation, condition(document, document.motor.demagnetisation_current_A, kPointer),
      kPointer);
}

RoundedInterval inductance_d(const Actuator& document) {
  return printed(document, document.motor.inductance_d_H, "/motor/inductance_d_H");
}

RoundedInterval inductance_q(const Actuator& document) {
  return printed(document, document.motor.inductance_q_H, "/motor/inductance_q_H");
}

}  // namespace torquewright::actuator::lint
