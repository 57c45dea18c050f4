// SPDX-License-Identifier: Apache-2.0
// The exported module's torque(), run. Oracle: the composed law of the actuator
// (actuator/region/torque_at.hpp and gear_losses.hpp) of the rotor's region; near rest the closed
// form with tanh; slopes: central differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using test::output_of;

using nlohmann::json;

constexpr double kAgreement = 1e-6;  // of the peak torque
constexpr double kPeak_Nm = 38.4;
constexpr double kFarFromRest = 9.0;  // smoothing speeds: 1 - tanh is 3e-8 there

struct Samples {
  std::vector<double> torque_Nm;
  std::vector<double> velocity_rad_s;
};

Samples random_samples(double greatest_rad_s) {
  std::mt19937 dice(7);
  std::uniform_real_distribution<double> speed(-greatest_rad_s, greatest_rad_s);
  std::uniform_real_distribution<double> torque(-1.5 * kPeak_Nm, 1.5 * kPeak_Nm);
  Samples samples;
  for (int i = 0; i < 2000; ++i) {
    samples.torque_Nm.push_back(torque(dice));
    samples.velocity_rad_s.push_back(speed(dice));
  }
  return samples;
}

/// Each made once.
const std::string& module_of(const Actuator& actuator) {
  static std::map<std::string, std::string> known;
  std::string& text = known[actuator.name];
  if (!text.empty()) return text;
  const ExportedDrive drive(actuator, exporters::python,
                            {.fit = LawFit::kBest, .friction = FrictionPlace::kJoint});
  return text = simulator_file(drive.subject(), exporters::python, {}).text;
}

/// What friction_module.py says.
json run_module(const Actuator& actuator, const Samples& samples) {
  const test::ScratchFolder folder;
  folder.write("region.py", module_of(actuator));
  folder.write(
      "samples.json",
      json{{"torque_Nm", samples.torque_Nm}, {"velocity_rad_s", samples.velocity_rad_s}}.dump());
  int status = 0;
  const std::string text =
      output_of(TORQUEWRIGHT_ARRAY_PYTHON " " TORQUEWRIGHT_SOURCE_DIR
                                          "/tests/actuator/exporters/friction_module.py " +
                    folder.path().string() + " 2>&1",
                status);
  EXPECT_EQ(status, 0) << text;
  const json answer = json::parse(text, nullptr, false);
  EXPECT_FALSE(answer.is_discarded()) << text;
  return answer;
}

/// Clipped at the rotor, before any friction, and carried to the joint.
double motor_Nm(const Actuator& actuator, const Region& rotor, double command_Nm,
                double speed_rad_s) {
  const double ratio = actuator.transmission.ratio;
  const JointRange range = rotor.at(ratio * speed_rad_s);
  return ratio * std::clamp(command_Nm / ratio, range.least.torque_Nm, range.greatest.torque_Nm);
}

double composed_Nm(const Actuator& actuator, const Region& rotor, double command_Nm,
                   double speed_rad_s) {
  Instant at;
  at.speed_rad_s = speed_rad_s;
  at.direction = std::copysign(1.0, speed_rad_s);
  const double before_Nm =
      motor_Nm(actuator, rotor, command_Nm, speed_rad_s) + drag_Nm(actuator, at);
  const double limit_Nm = actuator.transmission.peak_torque_Nm;
  return std::clamp(after_mesh_Nm(actuator, before_Nm, at.direction), -limit_Nm, limit_Nm);
}

/// Friction of every kind, a gear that breaks, and no two directions alike.
Actuator any_drive() {
  Actuator actuator = loaded_drive();
  actuator.name = "any drive";
  actuator.transmission.peak_torque_Nm = 36.0;
  actuator.effects.push_back(effect("stribeck_friction", {0.3, 0.8, 2.0}));
  actuator.effects.push_back(effect("asymmetric_friction", {0.2, 0.5, 0.01, 0.03}));
  actuator.effects.push_back(effect("quadratic_drag", {0.003}));
  actuator.effects.push_back(effect("eddy_current_drag", {0.6, 8.0}));
  return actuator;
}

class FrictionModule : public testing::Test {
 protected:
  void SetUp() override {
    int status = 0;
    output_of(TORQUEWRIGHT_ARRAY_PYTHON " -c 'import numpy' 2>&1", status);
    if (status != 0) GTEST_SKIP() << "python3-numpy is not installed";
  }
};

TEST_F(FrictionModule, IsTheComposedLaw) {
  for (const Actuator& actuator : {dry_drive(), loaded_drive(), any_drive()}) {
    SCOPED_TRACE(actuator.name);
    const Region rotor(actuator, {}, Side::kMotor);
    const Samples samples = random_samples(1.3 * rotor.greatest_speed_rad_s() / 6.0);
    const json answer = run_module(actuator, samples);
    const double far_rad_s = kFarFromRest * answer.at("smoothing_rad_s").get<double>();
    double worst_Nm = 0.0;
    for (std::size_t i = 0; i < samples.torque_Nm.size(); ++i) {
      const double speed_rad_s = samples.velocity_rad_s[i];
      const bool is_beyond = std::abs(6.0 * speed_rad_s) > rotor.greatest_speed_rad_s();
      if (std::abs(speed_rad_s) < far_rad_s || is_beyond) continue;
      const double expected_Nm = composed_Nm(actuator, rotor, samples.torque_Nm[i], speed_rad_s);
      for (const char* by : {"torque_Nm", "isaac_lab_Nm", "mjlab_Nm"}) {
        const double off_Nm = std::abs(answer.at(by)[i].get<double>() - expected_Nm);
        worst_Nm = std::max(worst_Nm, off_Nm);
        EXPECT_LE(off_Nm, kAgreement * kPeak_Nm) << by << " at " << speed_rad_s << " rad/s";
      }
    }
    std::printf("%s: torque() off by %.2g of the peak torque\n", actuator.name.c_str(),
                worst_Nm / kPeak_Nm);
  }
}

// Oracle: closed form. With s = tanh(w / smoothing), x = u - (0.4 + 0.02 |w|) s passes the gear as
// (d + b)/2 x + (d - b)/2 |x| s, d = 0.9 / 1.03 driving and b = 1 / (0.85 0.96) braking.
TEST_F(FrictionModule, TurnsOverSmoothlyAtRest) {
  const Actuator actuator = loaded_drive();
  const Region rotor(actuator, {}, Side::kMotor);
  const Samples samples = random_samples(1.5);
  const json answer = run_module(actuator, samples);
  const double smoothing_rad_s = answer.at("smoothing_rad_s");
  const double driving = 0.9 / 1.03;
  const double braking = 1.0 / (0.85 * 0.96);
  for (std::size_t i = 0; i < samples.torque_Nm.size(); ++i) {
    const double speed_rad_s = samples.velocity_rad_s[i];
    const double way = std::tanh(speed_rad_s / smoothing_rad_s);
    const double before_Nm = motor_Nm(actuator, rotor, samples.torque_Nm[i], speed_rad_s) -
                             (0.4 + 0.02 * std::abs(speed_rad_s)) * way;
    const double expected_Nm = 0.5 * (driving + braking) * before_Nm +
                               0.5 * (driving - braking) * std::abs(before_Nm) * way;
    EXPECT_NEAR(answer.at("torque_Nm")[i].get<double>(), expected_Nm, kAgreement * kPeak_Nm);
  }
}

// Oracle: central differences of the module's own torque(), of samples between which no corner
// lies: there both one-sided differences agree.
TEST_F(FrictionModule, HasTheSlopesOfItsTorque) {
  constexpr double kStep = 1e-5;
  for (const bool by_velocity : {false, true}) {
    Samples middle = random_samples(25.0);
    Samples before = middle;
    Samples after = middle;
    auto& low = by_velocity ? before.velocity_rad_s : before.torque_Nm;
    auto& high = by_velocity ? after.velocity_rad_s : after.torque_Nm;
    for (double& value : low) value -= kStep;
    for (double& value : high) value += kStep;
    const json answer = run_module(any_drive(), middle);
    const json below = run_module(any_drive(), before).at("torque_Nm");
    const json above = run_module(any_drive(), after).at("torque_Nm");
    std::size_t compared = 0;
    for (std::size_t i = 0; i < middle.torque_Nm.size(); ++i) {
      const double here_Nm = answer.at("torque_Nm")[i];
      const double left = (here_Nm - below[i].get<double>()) / kStep;
      const double right = (above[i].get<double>() - here_Nm) / kStep;
      const double tolerance = 1e-3 * (1.0 + std::abs(left));
      if (std::abs(left - right) > tolerance) continue;
      ++compared;
      const double slope = answer.at(by_velocity ? "by_velocity" : "by_torque")[i];
      EXPECT_NEAR(slope, 0.5 * (left + right), tolerance);
      const json& torch = answer.at("torch");
      if (torch.is_null()) continue;
      EXPECT_NEAR(torch[by_velocity ? 1 : 0][i].get<double>(), slope,
                  1e-9 * (1.0 + std::abs(slope)));
    }
    EXPECT_GE(compared, middle.torque_Nm.size() * 9 / 10);
  }
}

// By hand: the most that the joint sees is what it brakes with, (38.4 + friction) / (0.85 0.96);
// a gear that breaks at 36 Nm carries no more. Friction is in the torque, not in the joint's field.
TEST_F(FrictionModule, LeavesTheSimulatorRoomForBraking) {
  const json loaded = run_module(loaded_drive(), random_samples(1.0));
  for (const char* limit : {"joint_effort_limit", "effort_limit"}) {
    EXPECT_GE(loaded.at(limit).get<double>(), 38.8 / (0.85 * 0.96)) << limit;
    EXPECT_LE(loaded.at(limit).get<double>(), 40.5 / (0.85 * 0.96)) << limit;
  }
  EXPECT_EQ(run_module(any_drive(), random_samples(1.0)).at("joint_effort_limit"), 36.0);
  EXPECT_EQ(loaded.at("viscous_friction"), 0.0);
}

}  // namespace
}  // namespace torquewright::actuator
