// SPDX-License-Identifier: Apache-2.0
#include "hopper/flip/drive_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/region/motor_region.hpp"
#include "hopper/flip/linear_region.hpp"
#include "io/spec_error.hpp"

namespace torquewright::hopper {
namespace {

void require_possible(const actuator::Actuator& actuator,
                      const actuator::OperatingConditions& conditions) {
  std::vector<io::Fault> faults;
  for (const std::string& sentence : actuator::objections(actuator, conditions)) {
    faults.push_back({actuator.name, "", sentence});
  }
  if (!faults.empty()) throw io::SpecError(std::move(faults));
}

/// At the open circuit's voltage; refuses a drive that has none.
actuator::JointRange range_at_rest(const HeldBus& bus) {
  actuator::JointRange rest = bus.range(bus.open_circuit_V(), 0.0);
  if (!rest.is_empty) return rest;
  throw io::SpecError({{bus.actuator().name, "",
                        fmt::format("its region is empty at rest, by {}, at a bus voltage of "
                                    "{:.4g} V: no motion can be planned with it",
                                    name_of(rest.why_empty), bus.open_circuit_V())}});
}

}  // namespace

DriveRegion::DriveRegion(const actuator::Actuator& actuator,
                         const actuator::OperatingConditions& conditions,
                         const DriveRegionOptions& options) {
  require_possible(actuator, conditions);
  const HeldBus bus(actuator, conditions, options.shares_battery);
  const actuator::JointRange rest = range_at_rest(bus);
  const actuator::PhaseModel& model = bus.model();
  const double ratio = std::abs(actuator.transmission.ratio);
  greatest_speed_rad_s_ = no_load_speed_rad_s(model) / ratio;
  const double K = ratio * model.torque_constant_Nm_A;
  copper_W_Nm2_ = 1.5 * model.resistance_ohm / (K * K);
  if (options.limits == DriveLimits::kBox) {
    greatest_torque_Nm_ =
        (1.0 - options.current_margin) * std::max(-rest.least.torque_Nm, rest.greatest.torque_Nm);
    greatest_speed_rad_s_ *= 1.0 - options.voltage_margin;
    const double per_rad_s = greatest_torque_Nm_ / greatest_speed_rad_s_;
    for (const double sign : {1.0, -1.0}) {
      rows_.push_back({0.0, sign * per_rad_s, 0.0, -greatest_torque_Nm_});
    }
    return;
  }
  if (const std::optional<LinearRegion> linear = linear_region(bus)) {
    greatest_torque_Nm_ = (1.0 - options.current_margin) * linear->torque_Nm;
    for (const double sign : {1.0, -1.0}) {
      rows_.push_back({sign, sign * linear->per_speed_Nm_s_rad,
                       -(1.0 - options.voltage_margin) * linear->per_volt_Nm_V, 0.0});
    }
    return;
  }
  throw io::SpecError({{actuator.name, "", "its region is not linear: it cannot be planned with"}});
}

}  // namespace torquewright::hopper
