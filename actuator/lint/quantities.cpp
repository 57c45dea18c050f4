// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/quantities.hpp"

#include <cmath>
#include <string>

namespace torquewright::actuator::lint {
namespace {

constexpr const char* kConvention = "/motor/torque_constant_convention";

CurrentConvention convention(const Actuator& document) {
  return document.motor.torque_constant_convention;
}

}  // namespace

double product(double one, double other) { return one * other; }

std::optional<RoundedInterval> sheet_number(const Actuator& document, SheetKey key,
                                            const char* name) {
  if (!document.datasheet || !(*document.datasheet.*key)) return std::nullopt;
  return rounded(*(*document.datasheet.*key), std::string("/datasheet/") + name);
}

std::optional<RoundedInterval> sheet_condition(const Actuator& document, SheetKey key,
                                               const char* name) {
  const std::optional<RoundedInterval> number = sheet_number(document, key, name);
  if (!number) return std::nullopt;
  return exact(number->value, number->pointers.front());
}

RoundedInterval ratio(const Actuator& document) {
  const double magnitude = std::abs(document.transmission.ratio);
  const bool has_teeth = !document.transmission.source.empty();
  if (has_teeth) return exact(magnitude, "/gearbox/file");
  return magnitude == std::round(magnitude) ? exact(magnitude, "/gearbox/ratio")
                                            : rounded(magnitude, "/gearbox/ratio");
}

RoundedInterval sheet_ratio(const Actuator& document) {
  return document.datasheet && document.datasheet->joint_side ? ratio(document) : exact(1.0);
}

RoundedInterval efficiency(double value, const char* pointer) {
  if (value == 0.0 || value == 1.0) return exact(value, pointer);
  RoundedInterval interval = rounded(value, pointer);
  interval.high = std::min(interval.high, 1.0);
  return interval;
}

RoundedInterval sheet_efficiency(const Actuator& document) {
  if (!document.datasheet || !document.datasheet->joint_side) return exact(1.0);
  const Transmission& gear = document.transmission;
  if (!gear.source.empty()) return exact(gear.forward_efficiency, "/gearbox/file");
  return efficiency(gear.forward_efficiency, "/gearbox/forward_efficiency");
}

RoundedInterval torque_constant(const Actuator& document) {
  return rounded(document.motor.torque_constant_Nm_A, "/motor/torque_constant_Nm_A");
}

RoundedInterval phase_torque_constant(const Actuator& document) {
  const double per_ampere = phase_amperes_per_ampere(convention(document));
  return derive(product, torque_constant(document), exact(1.0 / per_ampere, kConvention));
}

RoundedInterval phase_back_emf(const Interpretation& interpretation) {
  const std::optional<double>& stated = interpretation.document.motor.back_emf_constant_V_s_rad;
  if (stated) {
    return derive(product, rounded(*stated, "/motor/back_emf_constant_V_s_rad"),
                  exact(1.0 / volts_per_phase_volt(interpretation.emf_measure), kConvention));
  }
  // Without losses, electrical power 1.5 Ke w i is mechanical power Kt i w.
  return derive(product, phase_torque_constant(interpretation.document), exact(2.0 / 3.0));
}

RoundedInterval phase_resistance(const Actuator& document) {
  const double factor = phase_ohms_per_ohm(document.motor.resistance_convention);
  return derive(product, rounded(document.motor.resistance_ohm, "/motor/resistance_ohm"),
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

RoundedInterval phase_current(const Interpretation& interpretation,
                              const RoundedInterval& current_A) {
  const double factor =
      interpretation.current_factor * phase_amperes_per_ampere(convention(interpretation.document));
  return derive(product, current_A, exact(factor, kConvention));
}

RoundedInterval peak_current(const Actuator& document) {
  return exact(document.drive.peak_current_A, "/drive/peak_current_A");
}

}  // namespace torquewright::actuator::lint
