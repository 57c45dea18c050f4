// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/linear_region.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/current_choice.hpp"
#include "actuator/region/motor_region.hpp"

namespace torquewright::hopper {
namespace {

constexpr int kLinearSpeeds = 60;
constexpr int kLinearVoltages = 9;
constexpr double kLinearBeyondNoLoad = 3.0;  // speeds that are looked at, in no-load speeds

/// By eq. (1), whatever else the model has.
LinearRegion linear_candidate(const HeldBus& bus) {
  const actuator::PhaseModel& model = bus.model();
  const double ratio = std::abs(bus.actuator().transmission.ratio);
  const double per_phase_V = ratio * model.torque_constant_Nm_A / model.resistance_ohm;
  LinearRegion region;
  region.current_Nm = ratio * torque_Nm(model, greatest_torque_current(model));
  region.gear_Nm = bus.actuator().transmission.peak_torque_Nm;
  region.per_speed_Nm_s_rad = per_phase_V * ratio * model.back_emf_V_s_rad;
  region.per_volt_Nm_V = per_phase_V * model.phase_volts_per_bus_volt;
  return region;
}

bool agree(const LinearRegion& region, const actuator::JointRange& range, double bus_V,
           double speed_rad_s) {
  const double middle_Nm = -region.per_speed_Nm_s_rad * speed_rad_s;
  const double half_Nm = region.per_volt_Nm_V * bus_V;
  const double most_Nm = std::min(region.current_Nm, region.gear_Nm);
  const double greatest_Nm = std::min(most_Nm, middle_Nm + half_Nm);
  const double least_Nm = std::max(-most_Nm, middle_Nm - half_Nm);
  const double tolerance_Nm = kLinear * most_Nm;
  if (range.is_empty) return greatest_Nm < least_Nm + tolerance_Nm;
  return std::abs(range.greatest.torque_Nm - greatest_Nm) <= tolerance_Nm &&
         std::abs(range.least.torque_Nm - least_Nm) <= tolerance_Nm;
}

}  // namespace

std::optional<LinearRegion> linear_region(const HeldBus& bus) {
  const LinearRegion region = linear_candidate(bus);
  if (!std::isfinite(region.per_volt_Nm_V) || !(region.per_speed_Nm_s_rad > 0.0)) return {};
  for (int v = 0; v < kLinearVoltages; ++v) {
    const double share =
        kLeastVoltage + (kGreatestVoltage - kLeastVoltage) * v / (kLinearVoltages - 1);
    const double bus_V = share * bus.open_circuit_V();
    const double no_load_rad_s = region.per_volt_Nm_V * bus_V / region.per_speed_Nm_s_rad;
    for (int i = -kLinearSpeeds; i <= kLinearSpeeds; ++i) {
      const double speed_rad_s = kLinearBeyondNoLoad * no_load_rad_s * i / kLinearSpeeds;
      if (!agree(region, bus.range(bus_V, speed_rad_s), bus_V, speed_rad_s)) return {};
    }
  }
  return region;
}

}  // namespace torquewright::hopper
