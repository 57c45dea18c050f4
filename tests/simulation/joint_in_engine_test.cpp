// SPDX-License-Identifier: Apache-2.0
// Oracles: the laws of simulation/joint, asked by hand along the same motion; simulate() on a
// dynamometer; a rotor on a spring, and one in a gap, in closed form; conservation of momentum.
#include "simulation/in_engine/joint_in_engine.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "actuator/effects/library.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "simulation/joint/joint_model.hpp"
#include "tests/actuator/effect_of_some_size.hpp"
#include "tests/simulation/simple_drive.hpp"

namespace torquewright::simulation {
namespace {

constexpr double kStep_s = 1e-4;
constexpr double kRotor_kg_m2 = 0.01;  // of simple_actuator(), at the output
constexpr double kWarm_K = 320.0;

SimulationOptions rotor_of_its_own() {
  SimulationOptions options;
  options.longest_step_s = kStep_s;
  options.motor_inertia_kg_m2 = kRotor_kg_m2;
  return options;
}

actuator::Actuator with_gear_losses() {
  actuator::Actuator actuator = simple_actuator();
  actuator.transmission.forward_efficiency = 0.9;
  actuator.transmission.backward_efficiency = 0.8;
  return actuator;
}

DriveNow making(double motor_Nm) {
  DriveNow drive;
  drive.motor_Nm = motor_Nm;
  return drive;
}

/// The motion and the torque of a step, by its number: both reverse, neither rests.
OutputStep output_of(int number, double position_rad) {
  return {position_rad, 2.0 * std::cos(0.37 * number) + 0.01, kStep_s};
}
double motor_Nm(int number) { return 3.0 * std::sin(0.23 * number + 0.4); }
double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

/// The torque in the middle of a step of a rigid train by the laws alone, states advanced in many
/// small parts: exact steps do not mind.
double by_the_laws_Nm(const actuator::Actuator& actuator, const JointModel& model,
                      JointState& state, const OutputStep& output, const DriveNow& drive) {
  constexpr int kParts = 64;
  const double direction = sign(output.speed_rad_s);
  const auto place = [&](double share) {
    state.position_rad = state.motor_position_rad =
        output.position_rad + share * output.step_s * output.speed_rad_s;
    state.speed_rad_s = state.motor_speed_rad_s = output.speed_rad_s;
  };
  const auto advance_half = [&] {
    for (int part = 0; part < kParts; ++part) {
      model.advance_states(state, drive, 0.5 * output.step_s / kParts);
    }
  };
  place(0.0);
  advance_half();
  place(0.5);
  const JointForces forces = model.forces(state, direction, drive);
  advance_half();
  return actuator::after_mesh_Nm(actuator, forces.before_mesh_Nm, direction) *
             (1.0 + forces.ripple_ratio) +
         forces.ripple_Nm;
}

TEST(JointInEngine, FollowsTheLawsOfEveryEffectOfTheLibrary) {
  for (const actuator::EffectKind* kind : actuator::effect_library()) {
    actuator::Actuator actuator = with_gear_losses();
    actuator.effects = {actuator::effect_of_some_size(*kind)};
    SimulationOptions options;
    options.motor_inertia_kg_m2 = 0.0;  // the engine's: no train is elastic
    JointInEngine joint(actuator, options);
    const JointModel model(actuator, 0.0, options);
    double position_rad = 0.3;
    JointState state = model.initial({position_rad, output_of(0, 0.0).speed_rad_s, kWarm_K, {}});
    state.temperature.winding_K = kWarm_K;
    model.settle_states(state, making(motor_Nm(0)));
    for (int number = 0; number < 40; ++number) {
      const OutputStep output = output_of(number, position_rad);
      const DriveNow drive = making(motor_Nm(number));
      const double acting_Nm = joint.advance(output, drive, sign(output.speed_rad_s), kWarm_K);
      EXPECT_NEAR(acting_Nm, by_the_laws_Nm(actuator, model, state, output, drive), 1e-9)
          << kind->name << " step " << number;
      position_rad += output.step_s * output.speed_rad_s;
    }
  }
}

// The drive asks simulate()'s own stepper: rotors go the same way to rounding.
TEST(JointInEngine, MovesARotorAsSimulateDoesOnADynamometer) {
  for (const auto& effects : std::vector<std::vector<actuator::Effect>>{
           {effect("torsional_compliance", {100.0, 0.05})},
           {effect("backlash", {0.002})},
           {effect("backlash", {0.002}), effect("torsional_compliance", {300.0, 0.0}),
            effect("coulomb_friction", {0.05}), effect("load_dependent_friction", {0.1, 0.1})}}) {
    actuator::Actuator actuator = with_gear_losses();
    actuator.effects = effects;
    constexpr double kSpeed_rad_s = 1.5;
    SimulationOptions options = rotor_of_its_own();
    options.longest_step_s = JointModel(actuator, 0.0, options).longest_step_s();
    const double step_s = options.longest_step_s;
    // From no torque on, so that nothing is twisted at the start; friction is made up for.
    const double start_A =
        -actuator::drag_Nm(actuator, {.speed_rad_s = kSpeed_rad_s, .direction = 1.0});
    const auto current_A = [&](double t) { return start_A + 400.0 * t; };
    Excitation excited = excitation(400 * step_s, step_s, current_A);
    excited.joints[0].speed_rad_s.assign(excited.time_s.size(), kSpeed_rad_s);
    const auto plant = simple_plant(Load::kDynamometer);
    const SimulatedRun run =
        simulate(*plant, {&actuator}, excited, {{0.0, kSpeed_rad_s, {}, {}}}, options);
    JointInEngine joint(actuator, options);
    ASSERT_TRUE(joint.is_elastic());
    for (std::size_t number = 0; number + 1 < excited.time_s.size(); ++number) {
      const double begin_s = excited.time_s[number];
      DriveNow drive;  // by the current, as simulate() has it
      drive.value = number == 0 ? start_A : current_A(begin_s + 0.5 * step_s);
      if (number == 0) joint.advance({0.0, kSpeed_rad_s, 1e-12}, drive, 1.0, 298.15);
      drive.value = current_A(begin_s + 0.5 * step_s);
      joint.advance({kSpeed_rad_s * begin_s, kSpeed_rad_s, step_s}, drive, 1.0, 298.15);
      EXPECT_NEAR(10.0 * joint.state().motor_position_rad,
                  run.joints[0].motor_position_rad[number + 1], 1e-9);
      EXPECT_NEAR(10.0 * joint.state().motor_speed_rad_s,
                  run.joints[0].motor_speed_rad_s[number + 1], 1e-7);
    }
  }
}

// J x'' = T1 - k x from the equilibrium under T0: x = T1/k + (T0 - T1)/k cos(w t). The mean torque
// of a step is what the rotor's momentum does not take.
TEST(JointInEngine, SwingsOnASpringInClosedForm) {
  constexpr double kStiffness_Nm_rad = 250.0;
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("torsional_compliance", {kStiffness_Nm_rad, 0.0})};
  JointInEngine joint(actuator, rotor_of_its_own());
  const double w_1_s = std::sqrt(kStiffness_Nm_rad / kRotor_kg_m2);
  joint.advance({0.0, 0.0, 1e-12}, making(2.0), 1.0, kWarm_K);
  EXPECT_NEAR(joint.state().motor_position_rad, 2.0 / kStiffness_Nm_rad, 1e-12);
  for (int number = 0; number < 400; ++number) {
    const double before_rad_s = joint.state().motor_speed_rad_s;
    const double mean_Nm = joint.advance({0.0, 0.0, kStep_s}, making(-1.0), 1.0, kWarm_K);
    const double time_s = (number + 1) * kStep_s;
    const double twist_rad = (-1.0 + 3.0 * std::cos(w_1_s * time_s)) / kStiffness_Nm_rad;
    // 200 parts a radian: (1/200)^2/24 of the phase. Where the rotor turns round it rests for the
    // remainder of its part, up to 1/200 of a radian each time.
    const bool has_turned = w_1_s * time_s > std::numbers::pi;
    const double amplitude_rad = 3.0 / kStiffness_Nm_rad;
    EXPECT_NEAR(joint.state().motor_position_rad, twist_rad,
                (has_turned ? 2.0 / 200.0 : 1e-5) * amplitude_rad);
    const double after_rad_s = joint.state().motor_speed_rad_s;
    if (before_rad_s * after_rad_s <= 0.0) continue;
    const double taken_Nm_s = kRotor_kg_m2 * (after_rad_s - before_rad_s);
    EXPECT_NEAR(mean_Nm * kStep_s, -1.0 * kStep_s - taken_Nm_s, 1e-12);
  }
}

// Until the rotor has crossed half the gap, sqrt(2 (b/2) J/T), the output feels nothing.
TEST(JointInEngine, FeelsNothingWhileTheRotorCrossesItsGap) {
  constexpr double kGap_rad = 0.02;
  constexpr double kTorque_Nm = 4.0;
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("backlash", {kGap_rad})};
  JointInEngine joint(actuator, rotor_of_its_own());
  joint.advance({0.0, 0.0, 1e-12}, making(0.0), 1.0, kWarm_K);
  const double crossed_s = std::sqrt(kGap_rad * kRotor_kg_m2 / kTorque_Nm);
  double felt_s = 0.0;
  for (int number = 0; felt_s == 0.0 && number < 1000; ++number) {
    const double torque_Nm = joint.advance({0.0, 0.0, kStep_s}, making(kTorque_Nm), 1.0, kWarm_K);
    if (torque_Nm > 0.0) felt_s = number * kStep_s;
  }
  EXPECT_NEAR(felt_s, crossed_s, kStep_s);
}

TEST(JointInEngine, GoesOnAsACopyDoes) {
  actuator::Actuator actuator = simple_actuator();
  actuator.effects = {effect("torque_lag", {0.02}), effect("torsional_compliance", {100.0, 0.0})};
  JointInEngine joint(actuator, rotor_of_its_own());
  joint.advance({0.0, 0.0, kStep_s}, making(2.0), 1.0, kWarm_K);
  joint.advance({0.0, 0.0, kStep_s}, making(-2.0), 1.0, kWarm_K);
  JointInEngine copy(joint);
  const double one_Nm = joint.advance({0.0, 0.1, kStep_s}, making(1.0), 1.0, kWarm_K);
  EXPECT_EQ(copy.advance({0.0, 0.1, kStep_s}, making(1.0), 1.0, kWarm_K), one_Nm);
}

}  // namespace
}  // namespace torquewright::simulation
