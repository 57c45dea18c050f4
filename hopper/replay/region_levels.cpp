// SPDX-License-Identifier: Apache-2.0
#include "hopper/replay/region_levels.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::hopper {
namespace {

using actuator::Interval;
using actuator::PhaseModel;

constexpr int kVoltages = 2 * RegionLevels::kLevelsPerOpenCircuit;
constexpr double kSameLevel = 1e-9;  // of a level: rounding
constexpr Interval kNothing{0.0, 0.0};

double between(double one, double other, double share) { return one + share * (other - one); }

Interval between(const Interval& one, const Interval& other, double share) {
  return {between(one.least_Nm, other.least_Nm, share),
          between(one.greatest_Nm, other.greatest_Nm, share)};
}

/// Nothing but voltage and temperature from outside: no battery, nor what stands for one.
actuator::Actuator on_held_bus(actuator::Actuator actuator) {
  actuator.battery.reset();
  std::erase_if(actuator.effects, [](const actuator::Effect& effect) {
    return effect.kind->acts == actuator::Acts::kBusVoltage;
  });
  return actuator;
}

/// A level and how far beyond it, of one level; rounding does not ask for the next one.
struct Place {
  int level;
  double share;
};
Place place_of(double levels) {
  const double nearest = std::round(levels);
  if (std::abs(levels - nearest) <= kSameLevel) return {static_cast<int>(nearest), 0.0};
  const double below = std::floor(levels);
  return {static_cast<int>(below), levels - below};
}

/// A motor without any torque, at every speed: where the voltage does not even drive its losses.
actuator::ClipPoints no_torque() { return {{-1.0, 1.0}, {0.0, 0.0}, {0.0, 0.0}}; }

}  // namespace

RegionLevels::RegionLevels(const actuator::Actuator& actuator, actuator::Rating rating)
    : actuator_(on_held_bus(actuator)),
      rating_(rating),
      step_V_(open_circuit_voltage_V(actuator, {}) / kLevelsPerOpenCircuit) {
  const double own_K = actuator.motor.winding_temperature_K;
  const auto holds = [&](double winding_K) {
    return actuator::objections(actuator_, {rating, {}, {}, winding_K}).empty();
  };
  first_K_ = own_K;
  // A curve knows no temperature: one level.
  if (actuator.envelope) models_.push_back(phase_model_at(actuator_, {rating, {}, {}, {}}));
  while (!actuator.envelope && first_K_ > own_K - kColder_K && holds(first_K_ - kStep_K)) {
    first_K_ -= kStep_K;
  }
  for (double level_K = first_K_;
       !actuator.envelope && level_K <= own_K + kHotter_K && holds(level_K);
       level_K = temperature_K(static_cast<int>(models_.size()))) {
    models_.push_back(phase_model_at(actuator_, {rating, {}, {}, level_K}));
  }
  tables_ = std::vector<Table>(kVoltages * models_.size());
}

RegionLevels::~RegionLevels() = default;

bool RegionLevels::are_of(const actuator::Actuator& actuator, actuator::Rating rating) const {
  const actuator::Actuator other = on_held_bus(actuator);
  return rating == rating_ &&
         step_V_ == open_circuit_voltage_V(actuator, {}) / kLevelsPerOpenCircuit &&
         other.motor == actuator_.motor && other.envelope == actuator_.envelope &&
         other.drive == actuator_.drive && other.transmission == actuator_.transmission &&
         other.effects == actuator_.effects && other.thermal == actuator_.thermal;
}

double RegionLevels::temperature_K(int temperature) const {
  return first_K_ + temperature * kStep_K;
}

double RegionLevels::temperature_level(double winding_K) const {
  const auto last = static_cast<double>(models_.size()) - 1.0;
  return std::clamp((winding_K - first_K_) / kStep_K, 0.0, last);
}

actuator::ClipTable RegionLevels::made(int voltage, int temperature) const {
  actuator::Actuator held = actuator_;
  held.drive.bus_voltage_V = voltage * step_V_;
  const actuator::Region region(held, {rating_, {}, {}, temperature_K(temperature)});
  const actuator::ClipPoints points = clip_points(mor_table(region));
  const bool has_none =
      points.speeds_rad_s.size() < 2 || points.speeds_rad_s.front() == points.speeds_rad_s.back();
  return actuator::ClipTable(has_none ? no_torque() : points);
}

actuator::TableView RegionLevels::at(int voltage, int temperature) const {
  const std::size_t place = static_cast<std::size_t>(voltage - 1) * models_.size() +
                            static_cast<std::size_t>(temperature);
  const actuator::ClipTable* table = tables_[place].load(std::memory_order_acquire);
  if (table != nullptr) return table->view();
  // Others may make the same meanwhile: the first one to be done stays.
  auto fresh = std::make_unique<const actuator::ClipTable>(made(voltage, temperature));
  const std::lock_guard lock(growing_);
  table = tables_[place].load(std::memory_order_relaxed);
  if (table == nullptr) {
    table = made_.emplace_back(std::move(fresh)).get();
    tables_[place].store(table, std::memory_order_release);
  }
  return table->view();
}

Interval RegionLevels::over_temperature(int voltage, double temperature, double speed_rad_s) const {
  if (voltage == 0) return kNothing;
  const auto [level, share] = place_of(temperature);
  const Interval below = actuator::limits(at(voltage, level), speed_rad_s);
  if (share == 0.0) return below;
  return between(below, actuator::limits(at(voltage, level + 1), speed_rad_s), share);
}

Interval RegionLevels::limits(double bus_V, double winding_K, double speed_rad_s) const {
  if (!(bus_V > 0.0)) return kNothing;
  const double temperature = temperature_level(winding_K);
  const auto [level, share] = place_of(std::min<double>(bus_V / step_V_, kVoltages));
  const Interval below = over_temperature(level, temperature, speed_rad_s);
  if (share == 0.0) return below;
  return between(below, over_temperature(level + 1, temperature, speed_rad_s), share);
}

PhaseModel RegionLevels::model(double bus_V, double winding_K) const {
  const auto [level, share] = place_of(temperature_level(winding_K));
  PhaseModel model = models_[static_cast<std::size_t>(level)];
  model.supply.open_circuit_V = bus_V;
  if (share == 0.0) return model;
  const PhaseModel& next = models_[static_cast<std::size_t>(level) + 1];
  model.torque_constant_Nm_A =
      between(model.torque_constant_Nm_A, next.torque_constant_Nm_A, share);
  model.back_emf_V_s_rad = between(model.back_emf_V_s_rad, next.back_emf_V_s_rad, share);
  model.resistance_ohm = between(model.resistance_ohm, next.resistance_ohm, share);
  return model;
}

}  // namespace torquewright::hopper
