// SPDX-License-Identifier: Apache-2.0
#include "hopper/planning/region/drive_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "actuator/region/current_choice.hpp"
#include "actuator/region/motor_region.hpp"
#include "hopper/planning/region/envelope_rows.hpp"
#include "hopper/planning/region/linear_region.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::hopper {
namespace {

// Of the no-load speed: the width over which a jump of the region at rest is drawn out, so that the
// solver has a slope there.
constexpr double kJumpWidth = 0.02;
constexpr double kFastestOfAny_rad_s = 100.0;  // in its place where no voltage sets one
constexpr double kPowerOverNoLoad = 4.0;  // speeds whose power is known well, in no-load speeds

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
  greatest_speed_rad_s_ = std::min(no_load_speed_rad_s(model) / ratio, kFastestOfAny_rad_s);
  jump_width_rad_s_ = kJumpWidth * greatest_speed_rad_s_;
  power_ = std::make_shared<const DrivePower>(
      bus, ratio * torque_Nm(model, greatest_torque_current(model)),
      actuator::greatest_speed_rad_s(model, kPowerOverNoLoad * ratio * greatest_speed_rad_s_) /
          ratio,
      jump_width_rad_s_);
  if (options.limits == DriveLimits::kBox) {
    be_box(rest, options);
  } else {
    be_region(bus, options);
  }
}

/// The rectangle in torque and speed; its torque is the variable's own bound.
void DriveRegion::be_box(const actuator::JointRange& rest, const DriveRegionOptions& options) {
  greatest_torque_Nm_ =
      (1.0 - options.current_margin) * std::max(-rest.least.torque_Nm, rest.greatest.torque_Nm);
  greatest_speed_rad_s_ *= 1.0 - options.voltage_margin;
  const double per_rad_s = greatest_torque_Nm_ / greatest_speed_rad_s_;
  for (const double sign : {1.0, -1.0}) {
    straight_.push_back({0.0, sign * per_rad_s, 0.0, -greatest_torque_Nm_});
  }
}

void DriveRegion::be_region(const HeldBus& bus, const DriveRegionOptions& options) {
  if (bus.model().envelope) return be_envelope(bus, options);
  const double keep_V = 1.0 - options.voltage_margin;
  if (const std::optional<LinearRegion> linear = linear_region(bus)) {
    greatest_torque_Nm_ = (1.0 - options.current_margin) * linear->current_Nm;
    greatest_torque_Nm_ = std::min(greatest_torque_Nm_, linear->gear_Nm);
    for (const double sign : {1.0, -1.0}) {
      straight_.push_back(
          {sign, sign * linear->per_speed_Nm_s_rad, -keep_V * linear->per_volt_Nm_V, 0.0});
    }
    return;
  }
  fitted_ = std::make_shared<const PlannedRegion>(
      bus, jump_width_rad_s_, PlannedRegionMargins{options.voltage_margin, options.current_margin});
  greatest_torque_Nm_ = fitted_->greatest_torque_Nm();
  const auto [least_Nm, greatest_Nm] = fitted_->range_Nm(bus.open_circuit_V(), 0.0);
  if (least_Nm < greatest_Nm) return;
  if (bus.model().supply.least_power_W == 0.0) {
    throw io::SpecError({{bus.actuator().name, "",
                          "it gives no power back to its bus (/drive/regeneration), so that its "
                          "region has no torque that brakes: no motion can be planned with it"}});
  }
  throw io::SpecError({{bus.actuator().name, "",
                        fmt::format("no torque is possible on both sides of rest, at a bus voltage "
                                    "of {:.4g} V less the margin: drag is too great; no motion can "
                                    "be planned with it",
                                    bus.open_circuit_V())}});
}

void DriveRegion::be_envelope(const HeldBus& bus, const DriveRegionOptions& options) {
  const EnvelopeRows found = envelope_rows(bus, 1.0 - options.voltage_margin);
  const double scale = 1.0 / (1.0 - options.current_margin);
  greatest_torque_Nm_ = found.greatest_Nm / scale;
  for (const double sign : {1.0, -1.0}) {
    for (const EnvelopeRows::Row& row : found.rows) {
      // sign torque <= at_rest + slope (sign speed)
      straight_.push_back({sign * scale, -sign * row.slope_Nm_s_rad, 0.0, -row.at_rest_Nm});
    }
    const double per_rad_s = greatest_torque_Nm_ / found.end_rad_s;
    straight_.push_back({0.0, sign * per_rad_s, 0.0, -greatest_torque_Nm_});
  }
}

}  // namespace torquewright::hopper
