// SPDX-License-Identifier: Apache-2.0
// Positions as an encoder counts them, no velocities: what is known of a drive's peak torque.
// Oracle: the equation of a pendulum, tau = I a + m g c sin(q), at accelerations written out.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "hopper/check/hopper_check.hpp"
#include "hopper/motion/rounding_steps.hpp"
#include "robot/mechanisms/constant_jacobian.hpp"
#include "tests/dynamics/random_numbers.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;

constexpr double kMass_kg = 1.2, kCenter_m = 0.15, kInertia_kg_m2 = 0.01;  // about the centre

Robot pendulum() {
  Robot robot;
  robot.name = "pendulum";
  dynamics::Body arm;
  arm.name = "arm";
  arm.joint.name = "hinge";
  arm.inertia = {kMass_kg, {0, 0, -kCenter_m}, kInertia_kg_m2 * Eigen::Matrix3d::Identity()};
  robot.tree.bodies = {dynamics::Body{}, arm};
  Drivetrain drivetrain;
  drivetrain.mechanism = std::make_shared<ConstantJacobian>(direct_drive());
  drivetrain.joints = {1};
  actuator::Actuator actuator;
  actuator.motor.torque_constant_Nm_A = 1.0;
  actuator.motor.resistance_ohm = 0.01;
  actuator.drive = {.bus_voltage_V = 1e5, .peak_current_A = 1e5, .continuous_current_A = {}};
  actuator.transmission.ratio = 1.0;
  drivetrain.actuators = {actuator};
  drivetrain.actuator_names = {"hinge"};
  drivetrain.actuator_files = {"drive.json"};
  robot.drivetrains = {drivetrain};
  return robot;
}

/// An angle over time and its second derivative.
struct Course {
  std::function<double(double t)> angle_rad;
  std::function<double(double t)> acceleration_rad_s2;
};

double torque_Nm(const Course& course, double t) {
  const double inertia_kg_m2 = kInertia_kg_m2 + kMass_kg * kCenter_m * kCenter_m;
  return inertia_kg_m2 * course.acceleration_rad_s2(t) +
         kMass_kg * dynamics::kGravity_m_s2 * kCenter_m * std::sin(course.angle_rad(t));
}

double peak_Nm(const Course& course, double duration_s) {
  double peak = 0.0;
  for (double t = 0.0; t <= duration_s; t += 5e-5) {
    peak = std::max(peak, std::abs(torque_Nm(course, t)));
  }
  return peak;
}

/// Three sines.
Course swings(oracles::Dice& dice) {
  Eigen::Array3d size, rate, phase;
  for (Index i = 0; i < 3; ++i) {
    rate[i] = 2.0 * std::numbers::pi * test::uniform(dice, 0.2, 5.0);
    size[i] = test::uniform(dice, 0.5, 6.0) / rate[i];
    phase[i] = test::uniform(dice, 0.0, 6.28);
  }
  return {[=](double t) { return (size * (rate * t + phase).sin()).sum(); },
          [=](double t) { return -(size * rate.square() * (rate * t + phase).sin()).sum(); }};
}

/// From one place to another with the least jerk, and rest before and after.
Course reach(oracles::Dice& dice) {
  const double from_s = test::uniform(dice, 0.05, 0.3), took_s = test::uniform(dice, 0.15, 0.6);
  const double way = test::uniform(dice, 0.3, 2.0), start = test::uniform(dice, -1.0, 1.0);
  const auto share = [=](double t) { return std::clamp((t - from_s) / took_s, 0.0, 1.0); };
  return {[=](double t) {
            const double x = share(t);
            return start + way * x * x * x * (10 + x * (-15 + 6 * x));
          },
          [=](double t) {
            const double x = share(t);
            return way / (took_s * took_s) * x * (60 + x * (-180 + 120 * x));
          }};
}

/// Accelerates and brakes with constant accelerations that jump.
Course jumps(oracles::Dice& dice) {
  const double half_s = test::uniform(dice, 0.05, 0.4), from_s = test::uniform(dice, 0.1, 0.2);
  const double rate = test::uniform(dice, 5.0, 60.0), start = test::uniform(dice, -0.5, 0.5);
  const auto since = [=](double t, double at_s) { return std::max(0.0, t - at_s); };
  return {[=](double t) {
            const auto half_square = [&](double at_s) { return 0.5 * std::pow(since(t, at_s), 2); };
            return start + rate * (half_square(from_s) - 2.0 * half_square(from_s + half_s) +
                                   half_square(from_s + 2.0 * half_s));
          },
          [=](double t) {
            if (t < from_s || t >= from_s + 2.0 * half_s) return 0.0;
            return t < from_s + half_s ? rate : -rate;
          }};
}

/// A slow swing, and a push of half a sine on the way: what a wide window would hide.
Course pushed(oracles::Dice& dice) {
  const Course slow = reach(dice);
  const double from_s = test::uniform(dice, 0.2, 0.6), took_s = test::uniform(dice, 0.005, 0.04);
  const double rate = std::numbers::pi / took_s;
  const double most = test::uniform(dice, 100.0, 600.0);
  return {[=](double t) {
            const double x = std::clamp(t - from_s, 0.0, took_s);
            const double after = std::max(0.0, t - from_s - took_s);
            return slow.angle_rad(t) +
                   most * (x / rate - std::sin(rate * x) / (rate * rate) + 2.0 / rate * after);
          },
          [=](double t) {
            const double x = t - from_s;
            const double push = x > 0.0 && x < took_s ? most * std::sin(rate * x) : 0.0;
            return slow.acceleration_rad_s2(t) + push;
          }};
}

struct Sensor {
  double rate_Hz = 1000.0;
  int bits = 14;
  double noise_steps = 0.0;  ///< Standard deviation before counting.
  double step_rad() const { return 2.0 * std::numbers::pi / std::pow(2.0, bits); }
};

Motion log_of(const Course& course, const Sensor& sensor, double duration_s, oracles::Dice& dice) {
  Motion motion;
  const auto samples = static_cast<Index>(duration_s * sensor.rate_Hz) + 1;
  motion.file = "log.csv";
  motion.positions.resize(1, samples);
  motion.velocity_origin = motion.acceleration_origin = Origin::kAbsent;
  motion.has_effort = {false};
  motion.efforts.setZero(1, samples);
  for (Index i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / sensor.rate_Hz;
    motion.times_s.push_back(t);
    double normal = 0.0;  // twelve uniform numbers make a normal one
    for (int k = 0; k < 12; ++k) normal += test::uniform(dice, -0.5, 0.5);
    const double counts = course.angle_rad(t) / sensor.step_rad() + sensor.noise_steps * normal;
    motion.positions(0, i) = sensor.step_rad() * std::round(counts);
  }
  return motion;
}

struct Count {
  int all = 0;
  int held = 0;
  double worst = 0.0;  ///< Share by which a stated peak is off.
};

using Draw = Course (*)(oracles::Dice&);

/// Of random motions of a second: how often the stated range holds the true peak.
Count counted(Draw draw, const Sensor& sensor, int motions) {
  constexpr double kDuration_s = 1.0;
  const Robot robot = pendulum();
  oracles::Dice dice(7);
  Count count;
  for (int i = 0; i < motions; ++i) {
    const Course course = draw(dice);
    Motion motion = log_of(course, sensor, kDuration_s, dice);
    const HopperReport report = check_motion(robot, motion, {});
    const PeakDoubt& stated = report.peak_doubts.front();
    const double truth_Nm = peak_Nm(course, kDuration_s);
    ++count.all;
    if (stated.least_Nm <= truth_Nm && truth_Nm <= stated.most_Nm) ++count.held;
    count.worst = std::max(count.worst, std::abs(stated.peak_Nm / truth_Nm - 1.0));
  }
  return count;
}

std::vector<Sensor> sensors(const std::vector<double>& rates_Hz) {
  std::vector<Sensor> all;
  for (const double rate_Hz : rates_Hz) {
    for (const int bits : {10, 12, 14, 17}) {
      for (const double noise : {0.0, 1.0}) all.push_back({rate_Hz, bits, noise});
    }
  }
  return all;
}

std::string words_of(const Sensor& sensor) {
  return fmt::format("{} bits at {} Hz, noise of {} steps", sensor.bits, sensor.rate_Hz,
                     sensor.noise_steps);
}

TEST(RoundedPositions, OfSmoothMotionsTellARangeThatHoldsThePeak) {
  for (const Draw draw : {swings, reach}) {
    for (const Sensor& sensor : sensors({200.0, 1000.0})) {
      SCOPED_TRACE(words_of(sensor));
      const Count count = counted(draw, sensor, 5);
      EXPECT_EQ(count.held, count.all);
    }
  }
}

// Narrower windows were off by 300 % and more here, and stated ranges beside the truth.
TEST(RoundedPositions, AtAHighRateAreAsGoodAsAtALowOne) {
  for (const Sensor& sensor : {Sensor{5000.0, 14, 0.0}, Sensor{5000.0, 12, 0.0}}) {
    SCOPED_TRACE(words_of(sensor));
    const Count count = counted(reach, sensor, 2);
    EXPECT_EQ(count.held, count.all);
    EXPECT_LE(count.worst, 0.1);
  }
}

// What a wide window would hide is in the range where narrower ones show it beyond their rounding.
TEST(RoundedPositions, OfJumpsAndPushesTellARangeThatHoldsThePeak) {
  for (const Draw draw : {jumps, pushed}) {
    for (const int bits : {14, 17}) {
      const Sensor sensor{1000.0, bits, 0.0};
      SCOPED_TRACE(words_of(sensor));
      const Count count = counted(draw, sensor, 8);
      EXPECT_EQ(count.held, count.all);
    }
  }
}

TEST(RoundedPositions, ChooseTheirWindowAndSayWhy) {
  oracles::Dice dice(7);
  const Course course = swings(dice);
  const Sensor sensor{1000.0, 12, 0.0};
  Motion motion = log_of(course, sensor, 1.0, dice);
  const HopperReport report = check_motion(pendulum(), motion, {});
  EXPECT_GT(motion.reach, 16);
  const auto said = [&](const char* rule) {
    for (const Finding& finding : report.check.findings) {
      if (finding.rule == rule) return finding.sentence;
    }
    return std::string();
  };
  EXPECT_NE(said("velocity-differentiated").find("positions in steps of 0.00153 (rad or m)"),
            std::string::npos)
      << said("velocity-differentiated");
  EXPECT_NE(said("torque-doubt").find("finer steps"), std::string::npos) << said("torque-doubt");
}

// Oracle: the step that made them; and that no double lies on steps by chance.
TEST(RoundingSteps, AreFoundAndNotInvented) {
  oracles::Dice dice(3);
  const Robot robot = pendulum();
  for (int i = 0; i < 10; ++i) {
    const Course course = swings(dice);
    for (const Sensor& sensor : sensors({200.0, 5000.0})) {
      const Motion motion = log_of(course, sensor, 1.0, dice);
      EXPECT_NEAR(rounding_steps(robot.tree, motion)[0] / sensor.step_rad(), 1.0, 1e-6)
          << words_of(sensor);
    }
    const Sensor exact{1000.0, 40, 0.0};
    EXPECT_EQ(rounding_steps(robot.tree, log_of(course, exact, 1.0, dice))[0], 0.0);
  }
}

// A text of six digits rounds the counts once more.
TEST(RoundingSteps, AreFoundInPrintedCounts) {
  std::vector<double> values;
  const double step = 2.0 * std::numbers::pi / 16384.0;
  for (int i = 0; i < 400; ++i) values.push_back(std::round(1e6 * step * (i * i % 977)) * 1e-6);
  EXPECT_NEAR(common_step(values) / step, 1.0, 1e-3);
}

// At a constant speed all differences are alike, and nothing is rounded.
TEST(RoundingSteps, AreNoneOfAnEvenCourse) {
  Motion motion;
  motion.positions.resize(1, 200);
  motion.velocity_origin = Origin::kAbsent;
  for (Index i = 0; i < 200; ++i) {
    motion.times_s.push_back(1e-3 * static_cast<double>(i));
    motion.positions(0, i) = 0.01 * static_cast<double>(i);
  }
  EXPECT_EQ(rounding_steps(pendulum().tree, motion)[0], 0.0);
}

}  // namespace
}  // namespace torquewright::hopper
