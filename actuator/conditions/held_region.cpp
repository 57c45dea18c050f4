// SPDX-License-Identifier: Apache-2.0
#include "actuator/conditions/held_region.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/mor/mor_table.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kNearlySameHeat_K = 1.0;  // to which the end of the winding's laws is known
constexpr double kJustInside = 1e-9;       // of a speed: back into the region after rounding
constexpr Interval kNothing{0.0, 0.0};

Actuator without_battery(Actuator actuator) {
  actuator.battery.reset();
  return actuator;
}

/// The furthest temperature from one to another that the actuator's laws have.
double furthest_K(const Actuator& on_bus, Rating rating, double from_K, double to_K) {
  const auto holds = [&](double winding_K) {
    return objections(on_bus, {rating, {}, {}, winding_K}).empty();
  };
  if (holds(to_K)) return to_K;
  while (std::abs(to_K - from_K) > kNearlySameHeat_K) {
    const double middle_K = 0.5 * (from_K + to_K);
    (holds(middle_K) ? from_K : to_K) = middle_K;
  }
  return from_K;
}

/// Whether the speed lies in the last part of those in the cell. Few do, so that the slowest end of
/// its conditions is asked first.
bool is_near_end(const RegionGrid& grid, const GridCell& cell, double speed_rad_s) {
  const double before_rad_s = std::abs(speed_rad_s) / RegionGrid::kBeforeEnd;
  for (std::size_t k = 0; k < cell.conditions; ++k) {
    const std::vector<double>& corners_rad_s = grid.greatest.corners_rad_s[cell.number[k]];
    if (before_rad_s <= std::min(-corners_rad_s.front(), corners_rad_s.back())) continue;
    return before_rad_s > end_rad_s(grid, cell);
  }
  return false;
}

}  // namespace

Actuator without_voltage_sag(Actuator actuator) {
  std::erase_if(actuator.effects,
                [](const Effect& effect) { return effect.kind->acts == Acts::kBusVoltage; });
  return actuator;
}

HeldRegion::HeldRegion(const Actuator& actuator, const OperatingConditions& conditions,
                       GridTemperatures temperatures)
    : on_bus_(without_battery(actuator)),
      conditions_{conditions.rating,
                  open_circuit_voltage_V(actuator, conditions),
                  {},
                  conditions.winding_temperature_K},
      coldest_K_(winding_temperature_K(actuator, conditions)),
      hottest_K_(coldest_K_) {
  // A curve knows no temperature.
  if (temperatures == GridTemperatures::kFreezingToLimit && !actuator.envelope) {
    const double own_K = coldest_K_;
    coldest_K_ = furthest_K(on_bus_, conditions.rating, own_K, own_K - kColder_K);
    hottest_K_ = furthest_K(on_bus_, conditions.rating, own_K, own_K + kHotter_K);
  }
  coldest_ = phase_model_at(on_bus_, at(*conditions_.bus_voltage_V, coldest_K_));
  hottest_ = phase_model_at(on_bus_, at(*conditions_.bus_voltage_V, hottest_K_));
  grid_ = region_grid(on_bus_, conditions_, Side::kJoint, temperatures, GridErrors::kAtMiddles);
  if (!grid_) {
    const JointRange rest = exact(*conditions_.bus_voltage_V, coldest_K_, 0.0);
    peak_torque_Nm_ = std::max(std::abs(rest.least.torque_Nm), std::abs(rest.greatest.torque_Nm));
    return;
  }
  for (const GridBound* bound : {&grid_->least, &grid_->greatest}) {
    for (const std::vector<double>& torques_Nm : bound->torques_Nm) {
      for (const double torque_Nm : torques_Nm) {
        peak_torque_Nm_ = std::max(peak_torque_Nm_, std::abs(torque_Nm));
      }
    }
  }
  double found_Nm = 0.0;
  for (const double error_Nm : grid_->cell_errors_Nm) {
    if (error_Nm <= kMostError * peak_torque_Nm_) found_Nm = std::max(found_Nm, error_Nm);
  }
  error_Nm_ = kErrorOverFound * found_Nm + kErrorOfPlaces * peak_torque_Nm_;
}

bool HeldRegion::is_of(const Actuator& actuator, const OperatingConditions& conditions) const {
  return conditions.rating == conditions_.rating &&
         conditions.winding_temperature_K == conditions_.winding_temperature_K &&
         open_circuit_voltage_V(actuator, conditions) == conditions_.bus_voltage_V &&
         actuator.motor == on_bus_.motor && actuator.envelope == on_bus_.envelope &&
         actuator.drive == on_bus_.drive && actuator.transmission == on_bus_.transmission &&
         actuator.effects == on_bus_.effects && actuator.thermal == on_bus_.thermal;
}

double HeldRegion::known_K(double winding_K) const {
  return std::clamp(winding_K, coldest_K_, hottest_K_);
}

OperatingConditions HeldRegion::at(double bus_V, double winding_K) const {
  OperatingConditions conditions{conditions_.rating, bus_V, {}, {}};
  if (!on_bus_.envelope) conditions.winding_temperature_K = known_K(winding_K);
  return conditions;
}

JointRange HeldRegion::exact(double bus_V, double winding_K, double speed_rad_s) const {
  return range_at(on_bus_, at(bus_V, winding_K), speed_rad_s);
}

/// The one to be used; nothing where none is.
std::optional<GridCell> HeldRegion::cell(double bus_V, double winding_K) const {
  winding_K = known_K(winding_K);
  if (!grid_ || !reaches(*grid_, bus_V, winding_K)) return std::nullopt;
  const GridCell cell = cell_at(*grid_, bus_V, winding_K);
  if (grid_->cell_errors_Nm[cell.cell] > kMostError * peak_torque_Nm_) return std::nullopt;
  return cell;
}

double HeldRegion::greatest_speed_rad_s(double bus_V, double winding_K) const {
  if (const std::optional<GridCell> cell = this->cell(bus_V, winding_K)) {
    return end_rad_s(*grid_, *cell);
  }
  return Region(on_bus_, at(bus_V, winding_K)).greatest_speed_rad_s();
}

std::optional<Interval> HeldRegion::tabulated(double bus_V, double winding_K,
                                              double speed_rad_s) const {
  const std::optional<GridCell> cell = this->cell(bus_V, winding_K);
  if (!cell || may_jump(*grid_, *cell, speed_rad_s) || is_near_end(*grid_, *cell, speed_rad_s)) {
    return std::nullopt;
  }
  return actuator::limits(*grid_, *cell, speed_rad_s);
}

Interval HeldRegion::limits(double bus_V, double winding_K, double speed_rad_s) const {
  if (!(bus_V > 0.0)) return kNothing;
  const std::optional<GridCell> cell = this->cell(bus_V, winding_K);
  if (cell && !may_jump(*grid_, *cell, speed_rad_s)) {
    const bool is_told = !is_near_end(*grid_, *cell, speed_rad_s) ||
                         std::abs(speed_rad_s) >= end_rad_s(*grid_, *cell);
    if (is_told) return actuator::limits(*grid_, *cell, speed_rad_s);
  }
  JointRange range = exact(bus_V, winding_K, speed_rad_s);
  if (range.is_empty) {
    const double last_rad_s = (1.0 - kJustInside) * greatest_speed_rad_s(bus_V, winding_K);
    range = exact(bus_V, winding_K, std::copysign(last_rad_s, speed_rad_s));
  }
  if (range.is_empty) return kNothing;
  return {range.least.torque_Nm, range.greatest.torque_Nm};
}

PhaseModel HeldRegion::model(double bus_V, double winding_K) const {
  PhaseModel model = coldest_;
  model.supply.open_circuit_V = bus_V;
  if (coldest_K_ == hottest_K_) return model;
  const double share = (known_K(winding_K) - coldest_K_) / (hottest_K_ - coldest_K_);
  const auto mix = [share](double cold, double hot) { return std::lerp(cold, hot, share); };
  model.torque_constant_Nm_A = mix(coldest_.torque_constant_Nm_A, hottest_.torque_constant_Nm_A);
  model.back_emf_V_s_rad = mix(coldest_.back_emf_V_s_rad, hottest_.back_emf_V_s_rad);
  model.resistance_ohm = mix(coldest_.resistance_ohm, hottest_.resistance_ohm);
  return model;
}

}  // namespace torquewright::actuator
