// SPDX-License-Identifier: Apache-2.0
// What a plan may ask of a drive. Oracle, unless a test names another: actuator::Region with the
// bus held at a voltage, by which `hopper check` judges, on grids that share no place with those of
// the fit.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "actuator/drive_check/demand.hpp"
#include "actuator/motor/actuator_spec.hpp"
#include "hopper/planning/region/drive_region.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/actuator/example_actuator.hpp"
#include "tests/actuator/random_actuator.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using dynamics::Jet;
using dynamics::Jet2;

Actuator document(const char* name) {
  return actuator::read_actuator(std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/") + name)
      .actuator;
}

std::vector<double> rows_at(const DriveRegion& region, double torque_Nm, double speed_rad_s,
                            double bus_V) {
  std::vector<double> rows(region.rows());
  region.rows<double>(torque_Nm, speed_rad_s, bus_V, rows);
  return rows;
}

bool allows(const DriveRegion& region, double torque_Nm, double speed_rad_s, double bus_V) {
  if (std::abs(torque_Nm) > region.greatest_torque_Nm()) return false;
  for (const double row : rows_at(region, torque_Nm, speed_rad_s, bus_V)) {
    if (row > 0.0) return false;
  }
  return true;
}

/// The greatest (sign 1) or least torque that is allowed, between one that is and far away.
double end_Nm(const DriveRegion& region, double inside_Nm, double sign, double speed_rad_s,
              double bus_V) {
  double outside_Nm = sign * 1.01 * region.greatest_torque_Nm();
  for (int i = 0; i < 50; ++i) {
    const double middle_Nm = 0.5 * (inside_Nm + outside_Nm);
    (allows(region, middle_Nm, speed_rad_s, bus_V) ? inside_Nm : outside_Nm) = middle_Nm;
  }
  return inside_Nm;
}

// --- without effects

class LinearDrive : public testing::TestWithParam<const char*> {};

// Oracle: the closed form of a dc motor, from the document's own numbers.
TEST_P(LinearDrive, HasTheRowsOfTheDcMotor) {
  const Actuator drive = document(GetParam());
  const double k = drive.motor.torque_constant_Nm_A * drive.transmission.ratio;
  const double R = drive.motor.resistance_ohm;
  const DriveRegion region(drive, {}, {DriveLimits::kMor, 0.05, 0.08});
  ASSERT_EQ(region.rows(), 2u);
  EXPECT_EQ(region.greatest_loss_Nm(), 0.0);
  const double most_Nm = k * drive.drive.peak_current_A;
  EXPECT_NEAR(region.greatest_torque_Nm(), 0.92 * most_Nm, 1e-9 * most_Nm);
  EXPECT_NEAR(region.greatest_speed_rad_s(), drive.drive.bus_voltage_V / k, 1e-9);
  for (const double torque_Nm : {-1.5 * most_Nm, 0.0, 40.0}) {
    for (const double speed_rad_s : {-40.0, 0.0, 7.0}) {
      for (const double bus_V : {33.0, 67.2, 87.0}) {
        const auto rows = rows_at(region, torque_Nm, speed_rad_s, bus_V);
        const double line_Nm = torque_Nm + k * k / R * speed_rad_s;
        const double room_Nm = 0.95 * k / R * bus_V;
        EXPECT_NEAR(rows[0], line_Nm - room_Nm, 1e-9 * most_Nm);
        EXPECT_NEAR(rows[1], -line_Nm - room_Nm, 1e-9 * most_Nm);
        EXPECT_NEAR(region.bus_power_W(torque_Nm, speed_rad_s, bus_V),
                    torque_Nm * speed_rad_s + R * std::pow(torque_Nm / k, 2), 1e-9);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FlipRegion, LinearDrive,
                         testing::Values("d151_knee.json", "d110a_ankle.json", "cassie_knee.json"));

// The straight rows are taken where the region says so, not where a document lists no effects:
// friction of less than a millionth of the peak torque (3.2e-4 Nm) is none, a little more is some.
TEST(FlipRegion, IsStraightOnlyWhereTheRegionIs) {
  Actuator drive = document("d151_knee.json");
  drive.effects = {actuator::effect("coulomb_friction", {2e-4})};
  EXPECT_EQ(DriveRegion(drive, {}, {}).greatest_loss_Nm(), 0.0);
  drive.effects = {actuator::effect("coulomb_friction", {5e-4})};
  EXPECT_GT(DriveRegion(drive, {}, {}).greatest_loss_Nm(), 0.0);
  drive.effects.clear();
  drive.transmission.backward_efficiency = 0.999;
  EXPECT_GT(DriveRegion(drive, {}, {}).greatest_loss_Nm(), 0.0);
}

// --- with effects

struct Case {
  const char* name;
  Actuator actuator;
  double most_loss;  ///< Of the greatest torque, that may be lost away from jumps.
};
void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

Actuator knee(std::vector<actuator::Effect> effects) {
  Actuator drive = document("d151_knee.json");
  drive.effects = std::move(effects);
  return drive;
}

Actuator inductive(Actuator drive, bool weakens_field) {
  drive.motor.inductance_d_H = drive.motor.inductance_q_H = 1e-4;
  drive.drive.field_weakening = weakens_field;
  return drive;
}

Actuator with_regeneration_limit(Actuator drive, double limit_W) {
  drive.drive.regeneration_limit_W = limit_W;
  return drive;
}

Actuator with_gear(Actuator drive, double forward, double backward, double peak_Nm) {
  drive.transmission.forward_efficiency = forward;
  drive.transmission.backward_efficiency = backward;
  drive.transmission.peak_torque_Nm = peak_Nm;
  return drive;
}

std::vector<Case> cases() {
  using actuator::effect;
  const double no_limit = actuator::kUnlimited;
  std::vector<Case> all{
      {"friction", knee({effect("coulomb_friction", {6.0}), effect("viscous_friction", {0.8})}),
       0.005},
      {"stribeck", knee({effect("stribeck_friction", {5.0, 9.0, 0.3})}), 0.005},
      {"load_friction", knee({effect("load_dependent_friction", {0.12, 0.1})}), 0.005},
      {"gear", with_gear(knee({}), 0.9, 0.85, no_limit), 0.005},
      {"gear_limit", with_gear(knee({effect("coulomb_friction", {3.0})}), 0.95, 0.9, 200.0), 0.005},
      {"saturation", knee({effect("torque_constant_saturation", {60.0, 2.0})}), 0.01},
      {"dead_time", knee({effect("inverter_dead_time", {1.5})}), 0.03},
      {"sag", knee({effect("voltage_sag", {0.03})}), 0.01},
      {"inductance", inductive(knee({}), false), 0.015},
      {"field_weakening", inductive(knee({effect("coulomb_friction", {4.0})}), true), 0.02},
      {"regeneration", with_regeneration_limit(knee({effect("viscous_friction", {0.5})}), 300.0),
       0.02},
      {"regeneration_corner", with_regeneration_limit(knee({}), 1500.0), 0.02},
      {"ripple",
       knee({actuator::harmonics("cogging_torque", {{6.0, 2.0, 0.1}}),
             actuator::harmonics("gear_ripple", {{2.0, 0.02, 0.0}}, true)}),
       0.005},
      {"asymmetric", knee({effect("asymmetric_friction", {3.0, 5.0, 0.2, 0.4})}), 0.005},
      {"document", document("ak80_9.json"), 0.01},
  };
  for (const unsigned seed : {1u, 4u, 5u, 11u}) {
    all.push_back({"drawn", actuator::random_actuator(seed, {true, true, false}), 0.03});
  }
  for (const unsigned seed : {1u, 5u, 7u}) {
    all.push_back({"drawn_weakening", actuator::random_actuator(seed, {true, true, true}), 0.03});
  }
  Actuator turned = knee({effect("asymmetric_friction", {3.0, 5.0, 0.2, 0.4})});
  turned.transmission.ratio = -turned.transmission.ratio;
  all.push_back({"negative_ratio", turned, 0.005});
  return all;
}

class DriveWithEffects : public testing::TestWithParam<Case> {
 protected:
  static constexpr DriveRegionOptions kShared{DriveLimits::kMor, 0.0, 0.0, true};

  void SetUp() override { region.emplace(drive, actuator::OperatingConditions{}, kShared); }

  /// Calls `at(bus_V, speed, true range)`, of motor and teeth.
  template <typename At>
  void over_the_grid(const At& at) {
    Actuator held = drive;
    held.battery.reset();
    const double fastest_rad_s = 3.1 * region->greatest_speed_rad_s();
    for (const double share : {0.45, 0.617, 0.783, 0.95, 1.0, 1.151, 1.289}) {
      held.drive.bus_voltage_V = share * open_V;
      const actuator::Region truth(held, {});
      for (int i = -170; i <= 170; ++i) {
        const double speed_rad_s = fastest_rad_s * i / 170.0 * std::abs(i / 170.0);
        is_at_nose = truth.at((1.0 + PlannedRegion::kNose) * speed_rad_s).is_empty;
        at(share * open_V, speed_rad_s, truth.at(speed_rad_s));
      }
    }
  }

  Actuator drive = GetParam().actuator;
  double open_V = actuator::open_circuit_voltage_V(drive, {});
  std::optional<DriveRegion> region;
  bool is_at_nose = false;  ///< What `at` is called for.
};

TEST_P(DriveWithEffects, StaysInsideTheRegion) {
  const double most_Nm = region->greatest_torque_Nm();
  std::size_t allowed = 0;
  over_the_grid([&](double bus_V, double speed_rad_s, const actuator::JointRange& range) {
    for (int j = -60; j <= 60; ++j) {
      const double torque_Nm = most_Nm * j / 60.0;
      if (!allows(*region, torque_Nm, speed_rad_s, bus_V)) continue;
      ++allowed;
      ASSERT_FALSE(range.is_empty) << torque_Nm << " Nm " << speed_rad_s << " rad/s " << bus_V;
      ASSERT_LE(torque_Nm, range.greatest.torque_Nm + 1e-9 * most_Nm)
          << speed_rad_s << " rad/s " << bus_V << " V";
      ASSERT_GE(torque_Nm, range.least.torque_Nm - 1e-9 * most_Nm)
          << speed_rad_s << " rad/s " << bus_V << " V";
    }
  });
  EXPECT_GT(allowed, 10000u);
}

// What is lost is what the drive says is lost, and little: by trial, the least round number above
// what was found.
TEST_P(DriveWithEffects, LosesNoMoreThanItStates) {
  const double most_Nm = region->greatest_torque_Nm();
  EXPECT_LE(region->greatest_loss_Nm(), GetParam().most_loss * most_Nm);
  double lost_Nm = 0.0;
  over_the_grid([&](double bus_V, double speed_rad_s, const actuator::JointRange& range) {
    if (range.is_empty || is_at_nose || region->is_near_jump(speed_rad_s)) return;
    const double stated_Nm = region->greatest_loss_Nm();
    const double width_Nm = range.greatest.torque_Nm - range.least.torque_Nm;
    if (width_Nm <= 4.0 * stated_Nm) return;
    const double middle_Nm = 0.5 * (range.greatest.torque_Nm + range.least.torque_Nm);
    ASSERT_TRUE(allows(*region, middle_Nm, speed_rad_s, bus_V)) << speed_rad_s << " " << bus_V;
    lost_Nm = std::max(
        {lost_Nm, range.greatest.torque_Nm - end_Nm(*region, middle_Nm, 1.0, speed_rad_s, bus_V),
         end_Nm(*region, middle_Nm, -1.0, speed_rad_s, bus_V) - range.least.torque_Nm});
  });
  // Places of the statement are 24 voltages' and 300 speeds': between them it may be some more.
  EXPECT_LE(lost_Nm, 1.5 * region->greatest_loss_Nm() + 1e-6 * most_Nm);
}

// Oracle: differences. A central difference of a C2 function over h is off by O(h^2) of its third
// derivative; steps that lead from one limiter to the next are a hundredth of the no-load speed
// wide, which sets h.
TEST_P(DriveWithEffects, HasTheDerivativesOfItsRows) {
  std::mt19937 random(7);
  const double most_Nm = region->greatest_torque_Nm();
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const double scale[3] = {most_Nm, region->greatest_speed_rad_s(), open_V};
  const auto values = [&](const std::array<double, 3>& x) {
    std::vector<double> out = rows_at(*region, x[0], x[1], x[2]);
    out.push_back(region->bus_power_W(x[0], x[1], x[2]));
    return out;
  };
  const auto slopes = [&](const std::array<double, 3>& x) {
    std::vector<Jet> out(region->rows());
    const Jet u = Jet::variable(x[0], 0), w = Jet::variable(x[1], 1), V = Jet::variable(x[2], 2);
    region->rows<Jet>(u, w, V, out);
    out.push_back(region->bus_power_W<Jet>(u, w, V));
    return out;
  };
  for (int sample = 0; sample < 60; ++sample) {
    const double far = sample < 30 ? 1.2 : 40.0 / scale[1];
    const std::array<double, 3> x{between(-1.5, 1.5) * most_Nm, between(-far, far) * scale[1],
                                  between(0.5, 1.3) * open_V};
    const Jet2 u = Jet2::variable(x[0], 0), w = Jet2::variable(x[1], 1),
               V = Jet2::variable(x[2], 2);
    std::vector<Jet2> exact(region->rows());
    region->rows<Jet2>(u, w, V, exact);
    exact.push_back(region->bus_power_W<Jet2>(u, w, V));
    const std::vector<double> here = values(x);
    const std::vector<Jet> here_slopes = slopes(x);
    for (int i = 0; i < 3; ++i) {
      const double h = 1e-7 * scale[i];
      std::array<double, 3> up = x, down = x;
      up[static_cast<std::size_t>(i)] += h;
      down[static_cast<std::size_t>(i)] -= h;
      const auto more = values(up), less = values(down);
      const auto more_slopes = slopes(up), less_slopes = slopes(down);
      for (std::size_t row = 0; row < here.size(); ++row) {
        ASSERT_TRUE(std::isfinite(here[row]));
        ASSERT_EQ(exact[row].value(), here[row]);
        ASSERT_EQ(here_slopes[row].value(), here[row]);
        const double size = std::abs(here[row]) + most_Nm;
        const double found = (more[row] - less[row]) / (2.0 * h) * scale[i];
        ASSERT_NEAR(exact[row].slope(i) * scale[i], found, 1e-5 * (size + std::abs(found)));
        ASSERT_NEAR(here_slopes[row].slope(i), exact[row].slope(i), 1e-9 * size / scale[i]);
        for (int j = 0; j < 3; ++j) {
          const double rise = more_slopes[row].slope(j) - less_slopes[row].slope(j);
          const double bend = rise / (2.0 * h) * scale[i] * scale[j];
          const double one = more_slopes[row].slope(j) - here_slopes[row].slope(j);
          // Third derivatives jump at knots: there the two sides differ by as much as they do here.
          const double jump = std::abs(2.0 * one - rise) / (2.0 * h) * scale[i] * scale[j];
          ASSERT_NEAR(exact[row].curvature(i, j) * scale[i] * scale[j], bend,
                      1e-4 * (size + std::abs(bend)) + jump)
              << "row " << row << " of " << here.size() - 1 << ", " << i << " " << j << ", at "
              << x[0] << " Nm " << x[1] << " rad/s " << x[2] << " V";
        }
      }
    }
  }
}

// Oracle: actuator::demand_at, which `hopper check` adds up. Near rest the gear's losses and drag
// turn round at once there and smoothly here. The current that weakens a field has an infinite
// slope where it can do no more, which no spline follows: there it is held in the mean.
TEST_P(DriveWithEffects, TakesThePowerThatTheCheckCounts) {
  const actuator::PhaseModel model = phase_model_at(drive, {});
  const double most_Nm = region->greatest_torque_Nm();
  double worst_W = 0.0;
  double greatest_W = 0.0;
  double sum_W = 0.0;
  double count = 0.0;
  over_the_grid([&](double bus_V, double speed_rad_s, const actuator::JointRange& range) {
    if (range.is_empty || bus_V > open_V) return;
    if (std::abs(speed_rad_s) < region->jump_width_rad_s()) return;
    for (int j = -20; j <= 20; ++j) {
      const double torque_Nm = most_Nm * j / 20.5;
      if (!allows(*region, torque_Nm, speed_rad_s, bus_V)) continue;
      const auto demand = actuator::demand_at(drive, model, drive.motor.winding_temperature_K,
                                              speed_rad_s, torque_Nm);
      ASSERT_TRUE(demand.has_value());
      const double error_W =
          std::abs(region->bus_power_W(torque_Nm, speed_rad_s, bus_V) - demand->bus_power_W);
      worst_W = std::max(worst_W, error_W);
      greatest_W = std::max(greatest_W, std::abs(demand->bus_power_W));
      sum_W += error_W;
      count += 1.0;
    }
  });
  EXPECT_LE(sum_W / count, 1e-3 * greatest_W);
  EXPECT_LE(worst_W, (drive.drive.field_weakening ? 0.1 : 1e-3) * greatest_W);
}

INSTANTIATE_TEST_SUITE_P(FlipRegion, DriveWithEffects, testing::ValuesIn(cases()),
                         [](const auto& one) {
                           return std::string(one.param.name) + std::to_string(one.index);
                         });

// --- a drive alone on its battery

// Oracle: the region with the battery's own sag, by which the check judges a drive that shares its
// battery with none: where the bus settles under the power, both say the same.
TEST(FlipRegion, AloneOnItsBatteryStaysInsideTheRegionThatSags) {
  Actuator drive =
      knee({actuator::effect("coulomb_friction", {4.0}), actuator::effect("voltage_sag", {0.02})});
  drive.battery.emplace();
  drive.battery->cell_open_circuit = {{1.0, 67.2}};
  drive.battery->cell_resistance_ohm = 0.06;
  drive.battery->discharge_limit_A = 40.0;
  drive.battery->charge_limit_A = 25.0;
  const DriveRegion region(drive, {}, {});
  const actuator::Region truth(drive, {});
  const actuator::Supply& supply = truth.model().supply;
  std::size_t allowed = 0;
  for (int i = -101; i <= 101; ++i) {
    const double speed_rad_s = 15.0 * i / 101.0;
    const actuator::JointRange range = truth.at(speed_rad_s);
    for (int j = -60; j <= 60; ++j) {
      const double torque_Nm = 320.0 * j / 60.0;
      const auto bus_V =
          actuator::bus_voltage_V(supply, region.bus_power_W(torque_Nm, speed_rad_s, 67.2));
      if (!bus_V || !allows(region, torque_Nm, speed_rad_s, *bus_V)) continue;
      ++allowed;
      // Power, and so the voltage, is smooth where the check's jumps, and held by 1e-3 elsewhere.
      const double doubt_Nm = std::abs(speed_rad_s) < region.jump_width_rad_s() ? 10.0 : 0.5;
      ASSERT_FALSE(range.is_empty);
      EXPECT_LE(torque_Nm, range.greatest.torque_Nm + doubt_Nm) << speed_rad_s;
      EXPECT_GE(torque_Nm, range.least.torque_Nm - doubt_Nm) << speed_rad_s;
    }
  }
  EXPECT_GT(allowed, 5000u);
}

// --- margins, box, refusals

TEST(FlipRegion, KeepsItsMargins) {
  const Actuator drive = knee({actuator::effect("coulomb_friction", {6.0})});
  const DriveRegion without(drive, {}, {});
  const DriveRegion with(drive, {}, {DriveLimits::kMor, 0.05, 0.08});
  const actuator::Region truth(drive, {});
  // Limited by current: that share of the bound, friction and all.
  for (const double speed_rad_s : {-6.0, -1.0, 1.0}) {
    const actuator::JointRange range = truth.at(speed_rad_s);
    ASSERT_EQ(range.greatest.limiter, actuator::Limiter::kCurrent);
    EXPECT_NEAR(end_Nm(with, 0.0, 1.0, speed_rad_s, 67.2), 0.92 * range.greatest.torque_Nm,
                1e-3 * 320.0);
  }
  // Limited by voltage: as without, at so much less of it.
  for (const double speed_rad_s : {9.0, 10.0}) {
    EXPECT_EQ(truth.at(speed_rad_s).greatest.limiter, actuator::Limiter::kVoltage);
    EXPECT_NEAR(end_Nm(with, 0.0, 1.0, speed_rad_s, 67.2),
                end_Nm(without, 0.0, 1.0, speed_rad_s, 0.95 * 67.2), 1e-9 * 320.0);
  }
}

// Oracle: the definition (DriveLimits::kBox): the greatest torque at rest and the no-load speed.
TEST(FlipRegion, BoxIsARectangle) {
  const Actuator drive = knee({actuator::effect("coulomb_friction", {6.0})});
  const DriveRegion box(drive, {}, {DriveLimits::kBox, 0.05, 0.08});
  const actuator::JointRange rest = actuator::Region(drive, {}).at(0.0);
  EXPECT_NEAR(box.greatest_torque_Nm(), 0.92 * rest.greatest.torque_Nm, 1e-9);
  const double end_rad_s = 0.95 * 67.2 / (0.32 * 20.0);
  EXPECT_NEAR(box.greatest_speed_rad_s(), end_rad_s, 1e-9);
  for (const double torque_Nm : {-280.0, 0.0, 280.0}) {
    for (const double sign : {-1.0, 1.0}) {
      for (const double bus_V : {40.0, 67.2}) {
        EXPECT_TRUE(allows(box, torque_Nm, sign * 0.999 * end_rad_s, bus_V));
        EXPECT_FALSE(allows(box, torque_Nm, sign * 1.001 * end_rad_s, bus_V));
      }
    }
  }
}

void expect_refusal(const Actuator& drive, const actuator::OperatingConditions& conditions,
                    const char* words) {
  try {
    const DriveRegion region(drive, conditions, {});
    FAIL() << "not refused: " << words;
  } catch (const io::SpecError& error) {
    EXPECT_NE(std::string(error.what()).find(drive.name), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(FlipRegion, RefusesADriveThatHasNothingAtRest) {
  // Cogging of more than the current's torque: nothing is there at every angle.
  expect_refusal(knee({actuator::harmonics("cogging_torque", {{6.0, 330.0, 0.0}})}), {},
                 "empty at rest");
  EXPECT_NO_THROW(
      DriveRegion(knee({actuator::harmonics("cogging_torque", {{6.0, 300.0, 0.0}})}), {}, {}));
  // Friction that the current cannot overcome: at rest it holds, moving there is nothing to plan.
  expect_refusal(knee({actuator::effect("coulomb_friction", {330.0})}), {}, "both sides of rest");
  EXPECT_NO_THROW(DriveRegion(knee({actuator::effect("coulomb_friction", {300.0})}), {}, {}));
  Actuator gives_nothing_back = knee({});
  gives_nothing_back.drive.regeneration = false;
  expect_refusal(gives_nothing_back, {}, "/drive/regeneration");
}

TEST(FlipRegion, RefusesConditionsThatCannotBeMet) {
  actuator::OperatingConditions conditions;
  conditions.rating = actuator::Rating::kContinuous;
  expect_refusal(document("cassie_knee.json"), conditions, "continuous rating");
}

// Oracle: the closed form, with copper's resistance at the winding's temperature (0.0039 a kelvin)
// and the current of the continuous rating.
TEST(FlipRegion, HoldsUnderTheConditions) {
  const Actuator drive = document("d151_knee.json");
  actuator::OperatingConditions conditions;
  conditions.rating = actuator::Rating::kContinuous;
  conditions.winding_temperature_K = 373.15;
  const DriveRegion region(drive, conditions, {});
  EXPECT_NEAR(region.greatest_torque_Nm(), 6.4 * 20.0, 1e-6);
  const double R = 0.28 * (1.0 + 0.0039 * 75.0);
  EXPECT_NEAR(rows_at(region, 10.0, 2.0, 60.0)[0], 10.0 + 6.4 / R * (6.4 * 2.0 - 60.0), 1e-6);
}

// --- known by its curve

Actuator curve_drive(const char* envelope) {
  const nlohmann::json root = {
      {"kind", "actuator"}, {"version", 1}, {"envelope", nlohmann::json::parse(envelope)}};
  return actuator::read_actuator(io::check_document(root, "actuator", "f", "")).actuator;
}

// Oracle: the curve that the document states, in closed form; braking counts no more than driving.
TEST(CurveDrive, AllowsItsCurveAndNothingBeyond) {
  const Actuator drive = curve_drive(
      R"({"peak_torque_Nm": 30, "corner_speed_rad_s": 10, "no_load_speed_rad_s": 20,
          "braking_torque_Nm": 45, "voltage_V": 24})");
  const DriveRegion region(drive, {}, {});
  constexpr double kBus_V = 24.0;
  for (const double speed : {-19.0, -13.0, -5.0, 0.0, 5.0, 12.0, 19.0}) {
    const double most_Nm = std::abs(speed) < 10.0 ? 30.0 : 3.0 * (20.0 - std::abs(speed));
    EXPECT_NEAR(end_Nm(region, 0.0, 1.0, speed, kBus_V), most_Nm, 1e-6) << speed;
    EXPECT_NEAR(end_Nm(region, 0.0, -1.0, speed, kBus_V), -most_Nm, 1e-6) << speed;
  }
  EXPECT_FALSE(allows(region, 0.0, 20.1, kBus_V));
}

TEST(CurveDrive, KeepsItsMargins) {
  const Actuator drive =
      curve_drive(R"({"peak_torque_Nm": 30, "no_load_speed_rad_s": 20, "voltage_V": 24})");
  const DriveRegionOptions margins{DriveLimits::kMor, 0.1, 0.2, false};
  const DriveRegion region(drive, {}, margins);
  // (1 - 0.2) 30 (1 - w/18)
  EXPECT_NEAR(end_Nm(region, 0.0, 1.0, 9.0, 24.0), 12.0, 1e-6);
}

TEST(CurveDrive, RefusesACurveThatBendsInward) {
  const Actuator drive = curve_drive(
      R"({"points": [{"speed_rad_s": 0, "torque_Nm": 30}, {"speed_rad_s": 5, "torque_Nm": 10},
                     {"speed_rad_s": 20, "torque_Nm": 5}, {"speed_rad_s": 21, "torque_Nm": 0}]})");
  try {
    const DriveRegion region(drive, {}, {});
    FAIL() << "accepted";
  } catch (const io::SpecError& error) {
    EXPECT_NE(std::string(error.what()).find("less fast with the speed beyond -5 rad/s"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace torquewright::hopper
