// SPDX-License-Identifier: Apache-2.0
// Oracle: the region itself (actuator/region), asked at that voltage and temperature alone.
#include "actuator/conditions/held_region.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "actuator/motor/actuator_spec.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::actuator {
namespace {

struct Held {
  std::string name;
  Actuator actuator;
};

Actuator on_battery(Actuator actuator) {
  actuator.battery.emplace();
  actuator.battery->cell_open_circuit = {{1.0, 50.0}};
  actuator.battery->cell_resistance_ohm = 0.1;
  return actuator;
}

Actuator with_friction() {
  Actuator actuator = on_battery(round_actuator());
  actuator.effects = {effect("torque_constant_saturation", {60.0, 2.0}),
                      effect("coulomb_friction", {4.0}), effect("viscous_friction", {0.5}),
                      effect("load_dependent_friction", {0.05, 0.05})};
  return actuator;
}

Actuator with_field_weakening() {
  Actuator actuator = with_friction();
  actuator.motor.inductance_d_H = actuator.motor.inductance_q_H = 2e-4;
  actuator.motor.pole_pairs = 10.0;
  actuator.drive.field_weakening = true;
  return actuator;
}

/// A convex corner, a slope, and full braking up to the end: nothing that a winding would have.
Actuator curve() {
  const nlohmann::json document = {{"kind", "actuator"},
                                   {"version", 1},
                                   {"name", "curve"},
                                   {"envelope",
                                    {{"points",
                                      {{{"speed_rad_s", 0}, {"torque_Nm", 40}},
                                       {{"speed_rad_s", 12}, {"torque_Nm", 30}},
                                       {{"speed_rad_s", 20}, {"torque_Nm", 0}}}},
                                     {"voltage_V", 48}}}};
  return read_actuator(io::check_document(document, "actuator", "f", "")).actuator;
}

std::vector<Held> held_actuators() {
  std::vector<Held> all{{"dc", on_battery(round_actuator())},
                        {"friction", with_friction()},
                        {"field weakening", with_field_weakening()},
                        {"turned", with_field_weakening()},
                        {"one way", with_friction()},
                        {"returns little", with_friction()},
                        {"curve", curve()}};
  all[3].actuator.transmission.ratio = -10.0;
  all[4].actuator.drive.regeneration = false;
  all[5].actuator.drive.regeneration_limit_W = 300.0;
  for (const unsigned seed : {0u, 1u, 2u, 4u, 5u, 7u, 9u}) {
    all.push_back({"drawn " + std::to_string(seed),
                   random_actuator(seed, {true, seed % 3 == 0, seed % 4 == 0})});
  }
  return all;
}

JointRange exactly(Actuator actuator, double bus_V, double winding_K, double speed_rad_s) {
  actuator.battery.reset();
  OperatingConditions conditions;
  conditions.bus_voltage_V = bus_V;
  if (!actuator.envelope) conditions.winding_temperature_K = winding_K;
  return Region(actuator, conditions).at(speed_rad_s);
}

double peak_Nm(const Actuator& actuator) {
  const double open_V = open_circuit_voltage_V(actuator, {});
  const JointRange rest = exactly(actuator, 1.2 * open_V, 293.15, 0.0);
  return std::max(std::abs(rest.least.torque_Nm), std::abs(rest.greatest.torque_Nm));
}

/// Calls `at(bus_V, winding_K, speed_rad_s)` at random: driving, braking and beyond the last speed,
/// from far too little voltage to far too much, frozen and burning.
template <typename At>
void anywhere(const Actuator& actuator, int times, const At& at) {
  std::mt19937 dice(11);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(dice);
  };
  const double open_V = open_circuit_voltage_V(actuator, {});
  const double end_rad_s = Region(actuator, {}).greatest_speed_rad_s();
  for (int i = 0; i < times; ++i) {
    const bool is_far = i % 4 == 0;
    const double bus_V = open_V * (is_far ? between(0.05, 1.9) : between(0.5, 1.2));
    const double winding_K = is_far ? between(240.0, 450.0) : between(273.15, 390.0);
    at(bus_V, winding_K, i % 10 == 0 ? 0.0 : 1.3 * end_rad_s * between(-1.0, 1.0));
  }
}

// What the table tells is within the error that it states, and it tells most of what is asked.
TEST(HeldRegion, TabulatesWithinTheErrorThatItStates) {
  for (const auto& [name, actuator] : held_actuators()) {
    SCOPED_TRACE(name);
    for (const auto temperatures :
         {GridTemperatures::kFreezingToLimit, GridTemperatures::kAsAsked}) {
      const HeldRegion region(actuator, {}, temperatures);
      const double own_K = actuator.motor.winding_temperature_K;
      int told = 0;
      anywhere(actuator, 400, [&](double bus_V, double winding_K, double speed_rad_s) {
        if (temperatures == GridTemperatures::kAsAsked) winding_K = own_K;
        const auto found = region.tabulated(bus_V, winding_K, speed_rad_s);
        if (!found) return;
        const JointRange range = exactly(actuator, bus_V, winding_K, speed_rad_s);
        ASSERT_FALSE(range.is_empty) << bus_V << " V " << speed_rad_s << " rad/s";
        ++told;
        EXPECT_NEAR(found->greatest_Nm, range.greatest.torque_Nm, region.error_Nm())
            << bus_V << " V " << winding_K << " K " << speed_rad_s << " rad/s";
        EXPECT_NEAR(found->least_Nm, range.least.torque_Nm, region.error_Nm())
            << bus_V << " V " << winding_K << " K " << speed_rad_s << " rad/s";
      });
      if (region.grid() != nullptr) {
        EXPECT_GT(told, 20);
      }
    }
  }
}

// Equations (10), (11): without losses the corners are linear in V and R(T), and so is the table,
// where the cap is there at rest, V >= R(T) I = 20 (1 + 0.0039 (T - 298.15)); in the cells below,
// where that corner ends, the stated error holds.
TEST(HeldRegion, IsExactForAMotorWithoutLosses) {
  const Actuator actuator = on_battery(round_actuator());
  const HeldRegion region(actuator, {}, GridTemperatures::kFreezingToLimit);
  ASSERT_NE(region.grid(), nullptr);
  const std::vector<double>& volts = region.grid()->voltages_V;
  const double ends_V = 20.0 * (1.0 + 0.0039 * (region.grid()->temperatures_K.back() - 298.15));
  const auto above = std::upper_bound(volts.begin(), volts.end(), ends_V);
  ASSERT_NE(above, volts.end());
  int exact = 0;
  anywhere(actuator, 400, [&](double bus_V, double winding_K, double speed_rad_s) {
    const JointRange range = exactly(actuator, bus_V, winding_K, speed_rad_s);
    if (range.is_empty) return;
    const Interval found = region.limits(bus_V, winding_K, speed_rad_s);
    const bool is_linear = bus_V >= *above;
    exact += is_linear ? 1 : 0;
    const double allowed_Nm = is_linear ? 1e-9 * 200.0 : region.error_Nm();
    EXPECT_NEAR(found.greatest_Nm, range.greatest.torque_Nm, allowed_Nm);
    EXPECT_NEAR(found.least_Nm, range.least.torque_Nm, allowed_Nm);
  });
  EXPECT_GT(exact, 100);
}

// Where the table does not reach, the region itself is asked.
TEST(HeldRegion, IsTheRegionBeyondItsTable) {
  for (const auto& [name, actuator] : held_actuators()) {
    SCOPED_TRACE(name);
    const HeldRegion region(actuator, {}, GridTemperatures::kFreezingToLimit);
    const double allowed_Nm = 1e-9 * peak_Nm(actuator);
    anywhere(actuator, 100, [&](double bus_V, double winding_K, double speed_rad_s) {
      const JointRange range = exactly(actuator, bus_V, winding_K, speed_rad_s);
      const bool is_known = region.grid() != nullptr && reaches(*region.grid(), bus_V, winding_K);
      if (is_known || range.is_empty) return;
      const Interval found = region.limits(bus_V, winding_K, speed_rad_s);
      EXPECT_NEAR(found.greatest_Nm, range.greatest.torque_Nm, allowed_Nm);
      EXPECT_NEAR(found.least_Nm, range.least.torque_Nm, allowed_Nm);
    });
  }
}

// By hand: k^2 w^2 / (4 R) = 300 W come back at most, so that the bounds jump at
// w = 2 sqrt(300 R(T)) / k, no line over the temperature. Either side of it is the region's.
TEST(HeldRegion, KnowsWhereABoundJumps) {
  Actuator actuator = on_battery(round_actuator());
  actuator.drive.regeneration_limit_W = 300.0;
  const HeldRegion region(actuator, {}, GridTemperatures::kFreezingToLimit);
  for (const double winding_K : {280.0, 310.0, 340.0, 370.0}) {
    const double resistance_ohm = 0.5 * (1.0 + 0.0039 * (winding_K - 298.15));
    const double jump_rad_s = 2.0 * std::sqrt(300.0 * resistance_ohm) / (0.5 * 10.0);
    for (const double off : {-3e-4, 3e-4}) {
      const double speed_rad_s = jump_rad_s * (1.0 + off);
      const JointRange range = exactly(actuator, 45.0, winding_K, speed_rad_s);
      EXPECT_EQ(range.least.torque_Nm > -160.0, off > 0.0);
      const Interval found = region.limits(45.0, winding_K, speed_rad_s);
      EXPECT_NEAR(found.least_Nm, range.least.torque_Nm, 1e-6);
      EXPECT_NEAR(found.greatest_Nm, range.greatest.torque_Nm, 1e-6);
    }
  }
}

// By hand, on the round motor: 5 Nm/A and 10 Nm/V at the joint, 200 Nm, overspeed at 14 rad/s.
TEST(HeldRegion, HoldsNoTorqueWithoutVoltageAndTheEndBeyondTheEnd) {
  const HeldRegion region(on_battery(round_actuator()), {}, GridTemperatures::kFreezingToLimit);
  for (const double bus_V : {0.0, -5.0}) {
    EXPECT_EQ(region.limits(bus_V, 300.0, 1.0).greatest_Nm, 0.0);
    EXPECT_EQ(region.limits(bus_V, 300.0, 1.0).least_Nm, 0.0);
  }
  EXPECT_NEAR(region.limits(0.1, 298.15, 0.0).greatest_Nm, 1.0, 1e-9);
  EXPECT_NEAR(region.limits(1e9, 298.15, 15.0).greatest_Nm, 200.0, 1e-9);
  for (const double bus_V : {50.0, 10.0}) {  // of the table and beyond it
    EXPECT_NEAR(region.limits(bus_V, 298.15, 100.0).least_Nm, -200.0, 1e-6);
    EXPECT_NEAR(region.limits(bus_V, 298.15, -100.0).greatest_Nm, 200.0, 1e-6);
  }
  EXPECT_EQ(region.limits(50.0, 1e9, 8.0).greatest_Nm, region.limits(50.0, 900.0, 8.0).greatest_Nm);
  EXPECT_EQ(region.limits(50.0, 0.0, 8.0).greatest_Nm, region.limits(50.0, 150.0, 8.0).greatest_Nm);
}

// Oracle: phase_model_at, which knows the laws of the temperature. They are linear.
TEST(HeldRegion, ModelsFollowTheTemperature) {
  const Actuator actuator = on_battery(round_actuator());
  const HeldRegion region(actuator, {}, GridTemperatures::kFreezingToLimit);
  for (const double winding_K : {298.15, 300.0, 287.3, 411.9}) {
    OperatingConditions conditions;
    conditions.winding_temperature_K = winding_K;
    const PhaseModel exact = phase_model_at(actuator, conditions);
    const PhaseModel model = region.model(33.0, winding_K);
    EXPECT_NEAR(model.resistance_ohm, exact.resistance_ohm, 1e-14);
    EXPECT_NEAR(model.torque_constant_Nm_A, exact.torque_constant_Nm_A, 1e-14);
    EXPECT_NEAR(model.back_emf_V_s_rad, exact.back_emf_V_s_rad, 1e-14);
    EXPECT_EQ(model.supply.open_circuit_V, 33.0);
    EXPECT_EQ(model.supply.resistance_ohm, 0.0);
  }
}

// Whatever moves a bound makes another actuator of it; what does not, does not.
TEST(HeldRegion, IsOfEveryActuatorWithTheSameRegion) {
  const Actuator own = with_friction();
  const HeldRegion region(own, {}, GridTemperatures::kAsAsked);
  const auto is_of = [&](auto change) {
    Actuator other = own;
    change(other);
    return region.is_of(other, {});
  };
  EXPECT_TRUE(is_of([](Actuator&) {}));
  EXPECT_TRUE(is_of([](Actuator& other) { other.name = "another"; }));
  EXPECT_TRUE(is_of([](Actuator& other) { other.battery->cell_resistance_ohm = 1.0; }));
  EXPECT_FALSE(is_of([](Actuator& other) { other.battery->series_cells = 2.0; }));
  EXPECT_FALSE(is_of([](Actuator& other) { other.motor.torque_constant_Nm_A = 0.4; }));
  EXPECT_FALSE(is_of([](Actuator& other) { other.drive.peak_current_A = 41.0; }));
  EXPECT_FALSE(is_of([](Actuator& other) { other.transmission.ratio = 11.0; }));
  EXPECT_FALSE(is_of([](Actuator& other) { other.effects[1].values[0] = 4.1; }));
  EXPECT_FALSE(is_of([](Actuator& other) { other.effects.pop_back(); }));
  EXPECT_FALSE(is_of([](Actuator& other) {
    other.thermal = Thermal{0.5, 1.0, 20.0, 100.0, 400.0};
  }));
  EXPECT_FALSE(region.is_of(own, {Rating::kContinuous, {}, {}, {}}));
  EXPECT_FALSE(region.is_of(own, {Rating::kPeak, {}, {}, 330.0}));
}

}  // namespace
}  // namespace torquewright::actuator
