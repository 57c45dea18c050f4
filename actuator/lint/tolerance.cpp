// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/tolerance.hpp"

#include <algorithm>
#include <string_view>

#include "actuator/lint/quantities.hpp"
#include "actuator/motor/statement.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kUnsaturated = 0.8;  // least part of a peak torque that saturation leaves

/// What differs from one motor to the next.
constexpr std::string_view kConstants[] = {
    "/motor/torque_constant_Nm_A", "/motor/back_emf_constant_V_s_rad",
    "/motor/resistance_ohm",       "/motor/inductance_d_H",
    "/motor/inductance_q_H",       "/motor/rotor_inertia_kg_m2"};

bool has_tolerance(const Actuator& document, std::string_view pointer) {
  const Statement* statement = find_statement(document, pointer);
  return statement != nullptr && statement->tolerance;
}

bool is_constant(std::string_view pointer) {
  return std::find(std::begin(kConstants), std::end(kConstants), pointer) != std::end(kConstants);
}

/// What is stated says its tolerance, or every constant that it follows from does.
bool says_tolerances(const Compared& compared) {
  if (has_tolerance(compared.document, compared.stated.pointers.front())) return true;
  std::size_t constants = 0, with_tolerance = 0;
  for (const std::string& pointer : compared.expected.pointers) {
    if (!is_constant(pointer)) continue;
    ++constants;
    if (has_tolerance(compared.document, pointer)) ++with_tolerance;
  }
  return constants > 0 && constants == with_tolerance;
}

/// What gears of unknown efficiency leave at least of a torque at the joint.
double least_after_gears(const Compared& compared) {
  const bool is_behind_gears = compared.document.datasheet &&
                               is_at_joint(compared.document, compared.stated.pointers.front());
  return is_behind_gears ? least_share_of_gears(compared.document) : 1.0;
}

/// Printed as stall torque over stall current, within their rounding: of the motor alone, in the
/// amperes of its terminals, without a back-EMF constant of its own.
bool is_torque_constant_of_stall(const Actuator& document) {
  if (!document.datasheet || document.motor.back_emf_constant_V_s_rad) return false;
  if (document.motor.torque_constant_convention != CurrentConvention::kDc) return false;
  if (document.datasheet->joint_side && document.transmission.ratio != 1.0) return false;
  const auto torque_Nm = sheet_number(document, &Datasheet::stall_torque_Nm, "stall_torque_Nm");
  const auto current_A = sheet_number(document, &Datasheet::stall_current_A, "stall_current_A");
  if (!torque_Nm || !current_A) return false;
  const RoundedInterval at_stall = derive(
      [](double torque, double amperes) { return torque / amperes; }, *torque_Nm, *current_A);
  const RoundedInterval constant = torque_constant(document);
  return !lies_above(at_stall, constant) && !lies_above(constant, at_stall);
}

}  // namespace

Tolerance catalogue(const Compared& compared) {
  if (says_tolerances(compared)) return {};
  return {1.0 - kCatalogueShare, 1.0 + kCatalogueShare};
}

Tolerance speeds(const Compared& compared) {
  Tolerance tolerance = catalogue(compared);
  if (is_torque_constant_of_stall(compared.document)) tolerance.least *= kUnsaturated;
  return tolerance;
}

Tolerance rated_torques(const Compared& compared) {
  Tolerance tolerance = catalogue(compared);
  tolerance.least *= least_after_gears(compared);
  return tolerance;
}

Tolerance peak_torques(const Compared& compared) {
  Tolerance tolerance = rated_torques(compared);
  tolerance.least *= kUnsaturated;
  return tolerance;
}

}  // namespace torquewright::actuator::lint
