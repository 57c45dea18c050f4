// SPDX-License-Identifier: Apache-2.0
// What recorders and sensors do to a log: uneven times, pauses, a drive that is off at times, a
// position that is noisy beside a clean velocity, no current. Oracle: what was put in. A joint
// turns to and fro by a sum of sines under a closed form of torque.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "identification/answer/analysis.hpp"
#include "identification/preparation/channel_grid.hpp"
#include "identification/preparation/output_motion.hpp"

namespace torquewright::identification {
namespace {

constexpr double kInertia_kg_m2 = 0.05, kCoulomb_Nm = 0.3, kViscous_Nm_s_rad = 0.1;
constexpr double kTorquePerAmpere_Nm_A = 0.8;
constexpr double kErrors = 4.0;  ///< Standard errors; fixed seeds.

struct Swing {
  double angle_rad = 0.0, speed_rad_s = 0.0, acceleration_rad_s2 = 0.0;

  explicit Swing(double time_s) {
    constexpr double kSines[][3] = {{2.0, 0.5, 0.3}, {4.9, 0.25, 1.1}, {8.3, 0.12, 2.0}};
    for (const auto& [rate, size, phase] : kSines) {
      angle_rad += size * std::sin(rate * time_s + phase);
      speed_rad_s += size * rate * std::cos(rate * time_s + phase);
      acceleration_rad_s2 -= size * rate * rate * std::sin(rate * time_s + phase);
    }
  }
  double current_A() const {
    const double friction_Nm =
        std::copysign(kCoulomb_Nm, speed_rad_s) + kViscous_Nm_s_rad * speed_rad_s;
    return (kInertia_kg_m2 * acceleration_rad_s2 + friction_Nm) / kTorquePerAmpere_Nm_A;
  }
};

struct Recorder {
  std::function<double(double)> next_s;  ///< Time of a row from the time of the row before.
  double position_noise_rad = 1e-4;
  double velocity_noise_rad_s = 0.0;  ///< 0: no velocity is logged.
  double velocity_delay_s = 0.0;
  double current_noise_A = 0.02;
};

std::function<double(double)> each(double step_s) {
  return [step_s](double t) { return t + step_s; };
}

struct Joint {
  Joint() {
    rig.joints = {""};
    rig.load.type = LoadType::kFree;
    rig.load.inertia_kg_m2 = kInertia_kg_m2;
    actuator.motor.torque_constant_Nm_A = 0.1;
    actuator.motor.resistance_ohm = 0.3;
    actuator.motor.pole_pairs = 7;
    actuator.motor.rotor_inertia_kg_m2 = 1e-12;
    actuator.drive.bus_voltage_V = 48.0;
    actuator.drive.peak_current_A = 40.0;
    actuator.transmission.ratio = 8.0;
  }

  static Log log(const Recorder& recorder, double runs_of_s = 8.0) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, 1.0);
    Log made;
    double t = 0.0;
    for (int r = 0; r < 3; ++r) {
      Run run;
      run.name = std::to_string(r);
      (r == 2 ? made.holdout_runs : made.train_runs).push_back(run.name);
      Channels& channels = run.joints.emplace_back();
      for (const double end_s = t + runs_of_s; t < end_s; t = recorder.next_s(t)) {
        const Swing at(t);
        run.time_s.push_back(t);
        channels[Quantity::kOutputPosition].push_back(at.angle_rad +
                                                      recorder.position_noise_rad * normal(random));
        channels[Quantity::kMotorCurrent].push_back(at.current_A() +
                                                    recorder.current_noise_A * normal(random));
        if (recorder.velocity_noise_rad_s == 0.0) continue;
        const Swing seen(t - recorder.velocity_delay_s);
        channels[Quantity::kOutputVelocity].push_back(
            seen.speed_rad_s + recorder.velocity_noise_rad_s * normal(random));
      }
      run.masked.assign(run.time_s.size(), 0);
      made.runs.push_back(std::move(run));
    }
    return made;
  }

  EquationResult current_equation(const Log& log) const {
    for (EquationResult& each : analyse(rig, log, 0, {&actuator}, {})) {
      if (each.quantity == "motor_current_A") return std::move(each);
    }
    return {};
  }

  Rig rig;
  actuator::Actuator actuator;
};

/// Both frictions, each alone and within its errors, and nothing else.
void expect_both_frictions(const EquationResult& found) {
  EXPECT_EQ(found.verdict, Verdict::kExplained);
  ASSERT_EQ(found.added.size(), 2u);
  for (const NamedEffect& each : found.added) {
    const bool is_coulomb = each.effect == "coulomb_friction";
    EXPECT_TRUE(is_coulomb || each.effect == "viscous_friction") << each.effect;
    const char* key = is_coulomb ? "coulomb_Nm" : "viscous_Nm_s_rad";
    const double truth = is_coulomb ? kCoulomb_Nm : kViscous_Nm_s_rad;
    EXPECT_NEAR(each.parameters.value(key, 0.0), truth,
                kErrors * each.parameters.standard_error(key));
    EXPECT_EQ(each.doubt, "");
  }
}

// Times jitter by up to half a step of 10 ms: differences over the index take the speed's share of
// that, 0.6 rad/s times some milliseconds, for noise.
TEST(Recorders, OfUnevenTimesLeaveTheFloorOfEvenOnes) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> jitter(-0.0049, 0.0049);
  int row = 0;
  const Joint joint;
  const EquationResult even = joint.current_equation(joint.log({each(0.01), 1e-5}));
  const EquationResult uneven = joint.current_equation(
      joint.log({[&](double) { return 0.01 * ++row + jitter(random); }, 1e-5}));
  expect_both_frictions(uneven);
  EXPECT_LT(uneven.noise_floor_rms, 1.6 * even.noise_floor_rms);
  EXPECT_LT(uneven.after.holdout_rms, 1.6 * even.after.holdout_rms);
}

// Oracle: the motion itself. A line between rows that are up to 20 ms apart is off by 12 rad/s^2
// times (20 ms)^2/8, 0.8 mrad, at the most; a cubic by 1e-5 of a radian.
TEST(Recorders, OfUnevenTimesAreReadOffCubics) {
  std::mt19937_64 random(3), unused;
  std::uniform_real_distribution<double> jitter(-0.0049, 0.0049);
  int row = 0;
  const Log log = Joint::log({[&](double) { return 0.01 * ++row + jitter(random); }, 0.0});
  const PreparationOptions options;
  ChannelGrid grid(log.runs.front(), 0, options, unused);
  const std::vector<double> angle_rad = grid.read_unfiltered(Quantity::kOutputPosition);
  for (std::size_t k = 3; k + 3 < angle_rad.size(); ++k) {
    const Swing at(grid.start_s() + static_cast<double>(k) * grid.step_s());
    EXPECT_NEAR(angle_rad[k], at.angle_rad, 1e-5) << k;
  }
}

// A row each 2.9 ms, and a pause of 20 to 60 ms three times a second.
TEST(Recorders, ThatPauseAreBridged) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> pause_s(0.02, 0.06), chance(0.0, 1.0);
  const Joint joint;
  const Log log = joint.log(
      {[&](double t) { return t + 0.0029 + (chance(random) < 0.009 ? pause_s(random) : 0.0); }});
  expect_both_frictions(joint.current_equation(log));
}

// 5 mrad of noise leave 5 mrad times 2 pi 8 Hz/sqrt(3) of a speed that is logged to 2 mrad/s.
TEST(Recorders, WithACleanVelocityTellTheMotionByIt) {
  const Joint joint;
  const Log log = joint.log({each(0.01), 5e-3, 2e-3});
  Bench bench = make_bench(joint.rig, log, 0, {&joint.actuator});
  EXPECT_TRUE(tells_motion_better(log, bench, noise_levels(log, 0)));
  expect_both_frictions(joint.current_equation(log));
}

// Just within and just beyond a third of what the derivative has; and a velocity that is late, as
// one that a drive filters is.
TEST(Recorders, WithAVelocityThatIsNoBetterOrLateTellTheMotionByThePosition) {
  const Joint joint;
  const auto takes_velocity = [&](double velocity_noise_rad_s, double delay_s) {
    const Log log = joint.log({each(0.01), 1e-3, velocity_noise_rad_s, delay_s});
    const Bench bench = make_bench(joint.rig, log, 0, {&joint.actuator});
    return tells_motion_better(log, bench, noise_levels(log, 0));
  };
  const double third_rad_s = 1e-3 * 2.0 * 3.14159265358979 * 8.0 / std::sqrt(3.0) / 3.0;
  EXPECT_TRUE(takes_velocity(0.85 * third_rad_s, 0.0));
  EXPECT_FALSE(takes_velocity(1.15 * third_rad_s, 0.0));
  EXPECT_FALSE(takes_velocity(0.3 * third_rad_s, 0.02));
}

// A drive that is off for 0.6 s of each 4, and whose current then reads 8 A.
TEST(Recorders, OfADriveThatIsOffAtTimesDoNotSeeWhatItDoesThen) {
  const Joint joint;
  Log log = joint.log({each(0.005)}, 12.0);
  for (std::size_t r = 0; r < log.runs.size(); ++r) {
    log.runs.change(r, [](identification::Run& run) {
      Channels& channels = run.joints[0];
      for (std::size_t i = 0; i < run.time_s.size(); ++i) {
        const bool is_off = std::fmod(run.time_s[i], 4.0) > 3.4;
        channels[Quantity::kEnabled].push_back(is_off ? 0.0 : 1.0);
        if (is_off) channels[Quantity::kMotorCurrent][i] = 8.0;
      }
    });
  }
  const EquationResult found = joint.current_equation(log);
  expect_both_frictions(found);
  EXPECT_LT(found.after.holdout_rms, 1.3 * found.noise_floor_rms);
}

// Duty or winding voltage, and the bus' voltage, without a current: V = d bus is known, and so is
// the current that it drives. The bus sags by 0.2 ohm.
TEST(Recorders, WithoutACurrentShowTheSag) {
  const Joint joint;
  for (const Quantity drive : {Quantity::kDuty, Quantity::kWindingVoltage}) {
    Log log = joint.log({each(0.005), 1e-5});
    std::mt19937_64 random(2);
    std::normal_distribution<double> noise_V(0.0, 0.005);
    for (std::size_t r = 0; r < log.runs.size(); ++r) {
      log.runs.change(r, [&](identification::Run& run) {
        Channels& channels = run.joints[0];
        channels[Quantity::kMotorCurrent].clear();
        for (const double t : run.time_s) {
          const Swing at(t);
          const double winding_V = 0.3 * at.current_A() + 0.8 * at.speed_rad_s;
          double bus_V = 48.0;
          for (int k = 0; k < 50; ++k) bus_V = 48.0 - 0.2 * at.current_A() * winding_V / bus_V;
          channels[drive].push_back(drive == Quantity::kDuty ? winding_V / bus_V : winding_V);
          channels[Quantity::kBusVoltage].push_back(bus_V + noise_V(random));
        }
      });
    }
    const auto results = analyse(joint.rig, log, 0, {&joint.actuator}, {});
    const auto bus = std::find_if(results.begin(), results.end(), [](const EquationResult& each) {
      return each.quantity == "bus_voltage_V";
    });
    ASSERT_NE(bus, results.end()) << name_of(drive);
    ASSERT_EQ(bus->added.size(), 1u) << name_of(drive);
    EXPECT_EQ(bus->added[0].effect, "voltage_sag");
    EXPECT_TRUE(is_certain(*bus, "voltage_sag"));
    EXPECT_NEAR(bus->added[0].parameters.value("resistance_ohm", 0.0), 0.2,
                kErrors * bus->added[0].parameters.standard_error("resistance_ohm"));
  }
}

}  // namespace
}  // namespace torquewright::identification
