// SPDX-License-Identifier: Apache-2.0
#include "actuator/motor/convention.hpp"

#include <numbers>

namespace torquewright::actuator {
namespace {

constexpr double kSqrt2 = std::numbers::sqrt2;
constexpr double kSqrt3 = std::numbers::sqrt3;

}  // namespace

double phase_amperes_per_ampere(CurrentConvention convention) {
  switch (convention) {
    case CurrentConvention::kDc:
      return 2.0 / kSqrt3;
    case CurrentConvention::kRmsPhase:
      return kSqrt2;
    case CurrentConvention::kPeakPhase:
      break;
  }
  return 1.0;
}

double phase_ohms_per_ohm(ResistanceConvention convention) {
  return convention == ResistanceConvention::kPhase ? 1.0 : 0.5;
}

double phase_volts_per_bus_volt(CurrentConvention convention, Modulation modulation) {
  if (convention == CurrentConvention::kDc) return 1.0 / kSqrt3;
  switch (modulation) {
    case Modulation::kSine:
      return 0.5;
    case Modulation::kSixStep:
      return 2.0 / std::numbers::pi;
    case Modulation::kSvpwm:
      break;
  }
  return 1.0 / kSqrt3;
}

double phase_volts_per_winding_volt(CurrentConvention convention) {
  return convention == CurrentConvention::kDc ? 1.0 / kSqrt3 : 1.0;
}

double back_emf_per_torque_constant(CurrentConvention convention) {
  switch (convention) {
    case CurrentConvention::kPeakPhase:
      return 2.0 / 3.0;
    case CurrentConvention::kRmsPhase:
      return kSqrt2 / 3.0;
    case CurrentConvention::kDc:
      break;
  }
  return 1.0;
}

std::string_view name_of(CurrentConvention convention) {
  switch (convention) {
    case CurrentConvention::kPeakPhase:
      return "peak_phase";
    case CurrentConvention::kRmsPhase:
      return "rms_phase";
    case CurrentConvention::kDc:
      break;
  }
  return "dc";
}

std::string_view name_of(ResistanceConvention convention) {
  switch (convention) {
    case ResistanceConvention::kPhase:
      return "phase";
    case ResistanceConvention::kLineToLine:
      return "line_to_line";
    case ResistanceConvention::kDc:
      break;
  }
  return "dc";
}

std::string_view name_of(Modulation modulation) {
  switch (modulation) {
    case Modulation::kSine:
      return "sine";
    case Modulation::kSixStep:
      return "six_step";
    case Modulation::kSvpwm:
      break;
  }
  return "svpwm";
}

}  // namespace torquewright::actuator
