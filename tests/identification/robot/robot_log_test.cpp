// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>

#include "actuator/effects/library.hpp"
#include "identification/answer/identify.hpp"
#include "identification/answer/parameters_json.hpp"
#include "identification/reading/read_log.hpp"
#include "identification/rig/joint_actuator_json.hpp"
#include "identification/robot/fitted_robot_json.hpp"
#include "identification/robot/robot_output.hpp"
#include "identification/robot/robot_study.hpp"
#include "identification/robot_search/simulated_names.hpp"
#include "identification/rollout/rollout.hpp"
#include "identification/rollout/servo_start.hpp"
#include "io/documents/document.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/identification/robot/leg.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification {
namespace {

using test::LegJoint;

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// What the leg has beyond its joints' numbers.
struct Beyond {
  double calf_kg = 0.3;   ///< Its mass; centre and inertia stay.
  double rises_Nm = 0.0;  ///< The calf's dry friction has this much times sin(angle) more.
  /// A spring beside the thigh's drive, relaxed at 0.4 rad.
  double spring_Nm_rad = 0.0;
};

constexpr double kRelaxed_rad = 0.4, kRelaxed_deg = kRelaxed_rad * 180.0 / std::numbers::pi;

/// The leg of leg.hpp in the engine's own words.
std::string leg_mjcf(const std::vector<LegJoint>& joints, const Beyond& beyond) {
  const auto joint = [&](std::size_t i, const char* axis) {
    return fmt::format(
        R"(<joint name="{}" axis="{}" armature="{}" damping="{}" frictionloss="{}" stiffness="{}" springref="{}"/>)",
        test::kLegJoints[i], axis, joints[i].armature_kg_m2, joints[i].damping_Nm_s_rad,
        joints[i].friction_Nm, i == 1 ? beyond.spring_Nm_rad : 0.0, kRelaxed_deg);
  };
  return fmt::format(
      R"(<mujoco><option timestep="0.0005" integrator="implicit"/><worldbody>
<body name="hip" pos="0.2 0.05 0">{}<inertial mass="0.7" pos="0 0.01 0" diaginertia="5e-4 9e-4 6e-4"/>
<body name="thigh" pos="0 0.1 0">{}<inertial mass="1.2" pos="-0.004 -0.02 -0.03" diaginertia="6e-3 6e-3 1e-3"/>
<body name="calf" pos="0 0 -0.21">{}<inertial mass="{}" pos="0.006 0 -0.12" diaginertia="2e-3 2e-3 6e-5"/>
</body></body></body></worldbody></mujoco>)",
      joint(0, "1 0 0"), joint(1, "0 1 0"), joint(2, "0 1 0"), beyond.calf_kg);
}

/// Commands that move all joints at once, each to frequencies of its own.
double command_rad(std::size_t joint, double time_s) {
  constexpr std::array<double, 3> kMiddle_rad = {0.05, 0.9, -1.6};
  constexpr std::array<double, 3> kSlow_Hz = {0.31, 0.23, 0.41};
  constexpr std::array<double, 3> kFast_Hz = {1.7, 2.3, 1.3};
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return kMiddle_rad[joint] + 0.35 * std::sin(kTurn * kSlow_Hz[joint] * time_s) +
         0.12 * std::sin(kTurn * kFast_Hz[joint] * time_s);
}

/// What the engine makes of the leg under the law of leg_rig_json(), logged at 200 Hz by encoders
/// of 16 bit a turn.
std::string log_of(const std::vector<LegJoint>& truth, const Beyond& beyond = {}) {
  const test::ScratchFolder folder;
  std::array<char, 1000> error{};
  const std::string file = folder.write("leg.xml", leg_mjcf(truth, beyond)).string();
  const std::unique_ptr<mjModel, Deleter> model(
      mj_loadXML(file.c_str(), nullptr, error.data(), error.size()));
  if (!model) throw std::runtime_error(error.data());
  const std::unique_ptr<mjData, Deleter> data(mj_makeData(model.get()));
  for (std::size_t i = 0; i < 3; ++i) data->qpos[i] = command_rad(i, 0.0);
  std::string log = "time_s,hip_command,hip_rad,thigh_command,thigh_rad,calf_command,calf_rad\n";
  constexpr double kStep_rad = 2.0 * std::numbers::pi / 65536.0;
  for (int step = 0; step < 40000; ++step) {
    const double time_s = 5e-4 * step;
    if (step % 10 == 0) log += fmt::format("{:.4f}", time_s);
    for (std::size_t i = 0; i < 3; ++i) {
      data->qfrc_applied[i] = 20.0 * (command_rad(i, time_s) - data->qpos[i]) - 0.5 * data->qvel[i];
      if (step % 10 != 0) continue;
      log += fmt::format(",{:.6f},{:.6f}", command_rad(i, time_s),
                         kStep_rad * std::round(data->qpos[i] / kStep_rad));
    }
    if (step % 10 == 0) log += '\n';
    model->dof_frictionloss[2] = truth[2].friction_Nm - beyond.rises_Nm * std::cos(data->qpos[2]);
    mj_step(model.get(), data.get());
  }
  return log;
}

struct Case {
  Rig rig;
  std::vector<JointActuator> actuators;
  Log log;
  Identification found;
};

Case identified(const std::vector<LegJoint>& stated, const std::vector<LegJoint>& truth) {
  const test::ScratchFolder folder;
  folder.write("leg.json", test::leg_json(stated).dump());
  const auto log = folder.write("leg.csv", log_of(truth));
  Case made;
  made.rig =
      read_rig(io::read_document(folder.write("rig.json", test::leg_rig_json().dump()), "rig"));
  for (std::size_t i = 0; i < made.rig.joints.size(); ++i) {
    made.actuators.push_back({made.rig.joints[i], actuator_of_joint(made.rig, i)});
  }
  made.log = read_log({log}, made.rig);
  made.found = identify({log}, made.rig, made.actuators);
  return made;
}

std::vector<std::string> certain_names(const Case& made) {
  std::vector<std::string> names;
  for (const EquationResult& equation : made.found.equations) {
    for (const NamedEffect& effect : equation.added) {
      if (!is_certain(equation, effect.effect)) continue;
      names.push_back(equation.joint + " " + effect.effect);
    }
  }
  return names;
}

std::string what_was_said(const Case& made) {
  std::string said;
  for (const EquationResult& equation : made.found.equations) {
    for (const NamedEffect& effect : equation.added) {
      said += fmt::format("{} {}: {} {}\n", equation.joint, effect.effect,
                          parameters_json(effect.parameters).dump(), effect.doubt);
    }
    for (const Confounded& group : equation.confounded) {
      said += fmt::format("{} {}\n", equation.joint, fmt::join(group.effects, " or "));
    }
  }
  return said;
}

const std::vector<LegJoint> kStated = {{0.01, 0.2, 0.1}, {0.01, 0.2, 0.1}, {0.02, 0.2, 0.1}};

// Oracle: MuJoCo, whose leg has what the documents state. Nothing is to be named.
TEST(RobotLog, NamesNothingWhereNothingIsMissing) {
  const Case made = identified(kStated, kStated);
  EXPECT_EQ(certain_names(made), std::vector<std::string>{});
  for (const EquationResult& equation : made.found.equations) {
    EXPECT_LT(equation.before.holdout_rms, 0.02) << equation.joint;
  }
}

// Oracle: MuJoCo, whose calf alone has 0.6 Nm of dry friction in the place of the 0.1 stated.
TEST(RobotLog, FindsTheFrictionAtItsJoint) {
  std::vector<LegJoint> truth = kStated;
  truth[2].friction_Nm = 0.6;
  const Case made = identified(kStated, truth);
  EXPECT_EQ(certain_names(made), std::vector<std::string>{"calf_joint coulomb_friction"})
      << what_was_said(made);
  for (const EquationResult& equation : made.found.equations) {
    for (const NamedEffect& effect : equation.added) {
      if (effect.effect != "coulomb_friction") continue;
      const double found_Nm = effect.parameters.value("coulomb_Nm", NAN);
      const double error_Nm = effect.parameters.standard_error("coulomb_Nm");
      EXPECT_NEAR(found_Nm, 0.6, 3.0 * error_Nm + 0.005);
    }
  }
}

/// A log with its rig, and the robot as the document states it.
struct Read {
  Rig rig;
  Log log;
  RobotModel model;
};

Read read_leg(const std::vector<LegJoint>& stated, const std::vector<LegJoint>& truth,
              const Beyond& beyond = {}) {
  const test::ScratchFolder folder;
  folder.write("leg.json", test::leg_json(stated).dump());
  Read read;
  read.rig =
      read_rig(io::read_document(folder.write("rig.json", test::leg_rig_json().dump()), "rig"));
  read.log = read_log({folder.write("leg.csv", log_of(truth, beyond))}, read.rig);
  std::vector<actuator::ReadActuator> drives;
  std::vector<const actuator::Actuator*> pointers;
  for (std::size_t i = 0; i < 3; ++i) drives.push_back(actuator_of_joint(read.rig, i));
  for (const auto& each : drives) pointers.push_back(&each.actuator);
  read.model = robot_model(read.rig, pointers);
  return read;
}

const FittedValue& fitted(const ValueFit& fit, std::size_t joint, const std::string& name) {
  return *std::find_if(fit.values.begin(), fit.values.end(), [&](const FittedValue& each) {
    return each.which.joint == joint && each.which.name == name;
  });
}

// Oracle: the numbers that MuJoCo's leg was given. The document's are wrong at every joint.
TEST(RobotValues, AreThoseOfTheEnginesLeg) {
  const std::vector<LegJoint> truth = {{0.018, 0.35, 0.05}, {0.025, 0.1, 0.25}, {0.035, 0.3, 0.3}};
  const Read read = read_leg(kStated, truth);
  const RobotStudy study = study_robot(read.rig, read.log, read.model, {});
  EXPECT_EQ(study.varies, std::vector<bool>(3, false));
  EXPECT_LT(study.fit.rms_after_rad, 0.1 * study.fit.rms_before_rad);
  // The integration's step and the encoder's leave less than these.
  const std::vector<std::pair<std::string, double>> within = {
      {"rotor_inertia_kg_m2", 1e-3}, {"viscous_Nm_s_rad", 0.02}, {"coulomb_Nm", 0.02}};
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const std::vector<double> is = {truth[joint].armature_kg_m2, truth[joint].damping_Nm_s_rad,
                                    truth[joint].friction_Nm};
    for (std::size_t k = 0; k < within.size(); ++k) {
      const FittedValue& value = fitted(study.fit, joint, within[k].first);
      EXPECT_NEAR(value.value, is[k], 4.0 * value.standard_error + within[k].second)
          << joint << " " << within[k].first;
    }
  }
  EXPECT_TRUE(study.load.errors.empty()) << sentence_of(study.load.errors.front());
}

// Oracle: MuJoCo's leg under gains of 20 Nm/rad, which the rig does not state. Each joint lifts
// what hangs on it, so that the scale is told.
TEST(RobotValues, GainsOfAServoAreFoundWhereTheJointsLift) {
  const std::vector<LegJoint> truth = {{0.018, 0.35, 0.05}, {0.025, 0.1, 0.25}, {0.035, 0.3, 0.3}};
  Read read = read_leg(kStated, truth);
  for (JointController& each : read.model.controllers) {
    each.law.stiffness_Nm_rad = 0.0;
    each.finds_stiffness = each.finds_delay = true;
    each.states_stiffness = false;
  }
  add_plain_friction(read.model);
  ValueFitOptions options;
  options.begin = servo_start(read.log, read.model);
  // The parabola of 0.1 s flattens what is quick: a start, no more.
  EXPECT_NEAR(options.begin->controllers[1].law.stiffness_Nm_rad, 20.0, 3.0);
  read.model.controllers = options.begin->controllers;
  options.most_simulated_s = 10.0;
  std::vector<FreeValue> values = free_values(read.model);
  std::erase_if(values, [](const FreeValue& each) { return each.of == FreeValue::Of::kOffset; });
  for (const FreeValue& each : controller_values(read.model)) values.push_back(each);
  const ValueFit fit = fit_values(read.log, read.model, values, options);
  EXPECT_LT(fit.rms_after_rad, 1e-3);
  for (std::size_t joint = 0; joint < 3; ++joint) {
    const FittedValue& gain = fitted(fit, joint, "controller_stiffness_Nm_rad");
    EXPECT_NEAR(gain.value, 20.0, 4.0 * gain.standard_error + 0.5) << joint;
    EXPECT_TRUE(gain.is_told()) << joint;
    const FittedValue& rotor = fitted(fit, joint, "rotor_inertia_kg_m2");
    EXPECT_NEAR(rotor.value, truth[joint].armature_kg_m2, 4.0 * rotor.standard_error + 2e-3);
  }
  EXPECT_NEAR(fitted(fit, 0, "command_delay_s").value, 0.0, 1e-3);
}

// Oracle: MuJoCo's leg, whose calf alone has dry friction that rises as it folds.
TEST(RobotValues, FrictionThatRisesWithTheAngleIsFoundAtItsJoint) {
  const std::vector<LegJoint> truth = {kStated[0], kStated[1], {0.02, 0.2, 0.3}};
  const Read read = read_leg(kStated, truth, {0.3, 0.3});
  const RobotStudy study = study_robot(read.rig, read.log, read.model, {});
  EXPECT_EQ(study.varies, (std::vector<bool>{false, false, true}));
  const Rollout before = roll_out(read.log, read.model, {1e3, 0.5, 10, true});
  const Rollout after = roll_out(read.log, study.fit.model, {1e3, 0.5, 10, true});
  EXPECT_LT(after.holdout.by_joint_rad[2], 0.2 * before.holdout.by_joint_rad[2]);
  ASSERT_EQ(after.traces.size(), 2u);
  EXPECT_EQ(after.traces[0].error_rad.size(), 3u);
}

// Oracle: MuJoCo's leg, whose calf weighs 0.1 kg more than the document says, where its centre is.
// A shift of the centre along the calf does much the same: which of them it is stays open.
TEST(RobotValues, ABodyThatWeighsMoreIsNamedWithWhatLooksLikeIt) {
  const Read read = read_leg(kStated, kStated, {0.4, 0.0});
  const RobotStudy study = study_robot(read.rig, read.log, read.model, {});
  ASSERT_FALSE(study.load.errors.empty());
  const LoadError& first = study.load.errors.front();
  EXPECT_EQ(first.readings.front().body, "calf") << sentence_of(first);
  ASSERT_EQ(study.load.limbs.size(), 1u);
  EXPECT_EQ(study.load.limbs[0].of, 12u);
  EXPECT_LT(study.load.limbs[0].told, 12u);
}

/// Few laws, of which each takes its time.
const auto kSomeLaws = [](const std::string& effect) {
  return effect == "parallel_spring" || effect == "stribeck_friction" || effect == "torque_lag";
};

// Oracle: MuJoCo's leg, whose thigh has a spring that no document states, and another friction. The
// joint's friction is no effect of its own: it is a number of every fit.
TEST(SimulatedSearch, FindsASpringAtItsJointAndNothingElse) {
  std::vector<LegJoint> truth = kStated;
  truth[1].friction_Nm = 0.2;
  const Read read = read_leg(kStated, truth, {0.3, 0.0, 2.0});
  RobotStudy study = study_robot(read.rig, read.log, read.model, {});
  const SimulatedSearch search =
      search_by_simulation(read.log, read.model, NamedByJoint(3), {}, kSomeLaws, study);
  ASSERT_EQ(search.found.size(), 1u);
  const SimulatedEffect& spring = search.found.front();
  EXPECT_EQ(spring.joint, 1u);
  EXPECT_EQ(spring.effect.kind->name, "parallel_spring");
  EXPECT_TRUE(spring.rivals.empty());
  EXPECT_LT(spring.after_rad, 0.2 * spring.before_rad);
  ASSERT_EQ(spring.values.size(), 2u);
  EXPECT_NEAR(spring.values[0].value, 2.0, 4.0 * spring.values[0].standard_error + 0.02);
  EXPECT_NEAR(spring.values[1].value, kRelaxed_rad, 4.0 * spring.values[1].standard_error + 0.02);
  const FittedValue& friction = fitted(study.fit, 1, "coulomb_Nm");
  EXPECT_NEAR(friction.value, 0.2, 4.0 * friction.standard_error + 0.02);
}

// Oracle: MuJoCo's leg as its document states it.
TEST(SimulatedSearch, FindsNothingWhereNothingIsMissing) {
  const Read read = read_leg(kStated, kStated);
  RobotStudy study = study_robot(read.rig, read.log, read.model, {});
  const SimulatedSearch search =
      search_by_simulation(read.log, read.model, NamedByJoint(3), {}, kSomeLaws, study);
  EXPECT_TRUE(search.found.empty())
      << search.found.front().effect.kind->name << " " << search.found.front().sigmas;
  for (const auto& names : search.tried) EXPECT_FALSE(names.empty());
}

NamedEffect named_lag(double time_constant_s) {
  NamedEffect lag;
  lag.effect = "torque_lag";
  lag.parameters.numbers = {{"time_constant_s", time_constant_s}};
  return lag;
}

// A balance of torques that names a lag, and misses the spring that a simulation found: the lag was
// tried there and is rejected, the spring is named with its numbers.
TEST(SimulatedSearch, JudgesWhatABalanceOfTorquesNamed) {
  EquationResult balance;
  balance.joint = "thigh_joint";
  balance.unit = "Nm";
  balance.is_noise_after = true;
  balance.added = {named_lag(0.01)};
  balance.confounded = {{{"torque_lag", "viscous_friction"}, false, "", ""}};
  SimulatedEffect spring;
  spring.joint = 1;
  spring.effect = actuator::neutral(*actuator::find_effect("parallel_spring"));
  FreeValue stiffness;
  stiffness.of = FreeValue::Of::kEffect;
  stiffness.name = "stiffness_Nm_rad";
  spring.values = {{stiffness, 0.0, 2.0, 0.1, false, false}};
  spring.sigmas = 40.0;
  SimulatedSearch search{{spring}, {{}, {"torque_lag", "parallel_spring"}, {}}};
  const std::vector<std::string>& joints = test::kLegJoints;
  std::vector<EquationResult> equations = {balance};
  judge_names(search, {}, joints, equations);
  ASSERT_EQ(equations[0].added.size(), 1u);
  EXPECT_EQ(equations[0].added[0].effect, "parallel_spring");
  EXPECT_EQ(equations[0].added[0].parameters.value("stiffness_Nm_rad", 0.0), 2.0);
  EXPECT_TRUE(is_certain(equations[0], "parallel_spring"));
  EXPECT_TRUE(equations[0].confounded.empty());
  ASSERT_EQ(equations[0].rejected.size(), 1u);
  EXPECT_EQ(equations[0].rejected[0].effect, "torque_lag");
  EXPECT_EQ(equations[0].verdict, Verdict::kExplained);
  // Where another law follows as well, both are said.
  search.found[0].rivals = {"upper_end_stop"};
  equations = {balance};
  judge_names(search, {}, joints, equations);
  EXPECT_FALSE(is_certain(equations[0], "parallel_spring"));
  EXPECT_EQ(equations[0].verdict, Verdict::kCannotTell);
}

// Oracle: MuJoCo's own motion. Where the documents are right the simulation stays at it to some
// steps of the encoder; with 0.6 Nm of friction that they do not state it is far off at that joint.
TEST(RobotLog, IsFollowedByTheSimulationUnderTheJointsOwnLaws) {
  const auto errors = [](const std::vector<LegJoint>& stated, const std::vector<LegJoint>& truth) {
    const Read read = read_leg(stated, truth);
    return roll_out(read.log, read.model, {1.0, 0.0, 100, false});
  };
  const Rollout right = errors(kStated, kStated);
  EXPECT_GT(right.holdout.windows, 2u);
  EXPECT_EQ(right.train.diverged + right.holdout.diverged, 0u);
  EXPECT_LT(right.holdout.all_rad, 2e-3);
  std::vector<LegJoint> truth = kStated;
  truth[2].friction_Nm = 0.6;
  const Rollout wrong = errors(kStated, truth);
  EXPECT_GT(wrong.holdout.by_joint_rad[2], 5.0 * right.holdout.by_joint_rad[2]);
  EXPECT_LT(wrong.holdout.by_joint_rad[0], 2e-3);
}

/// Positions of MuJoCo's joints less the log's, in a file that holds the loops, over the whole run;
/// the first half second does not count.
double left_in_engine_rad(const std::string& mjcf, const Run& run) {
  const test::ScratchFolder folder;
  std::array<char, 1000> error{};
  const std::string file = folder.write("leg.xml", mjcf).string();
  const std::unique_ptr<mjModel, Deleter> model(
      mj_loadXML(file.c_str(), nullptr, error.data(), error.size()));
  if (!model) throw std::runtime_error(error.data());
  const std::unique_ptr<mjData, Deleter> data(mj_makeData(model.get()));
  const auto position = [&](std::size_t joint, std::size_t sample) {
    return run.joints[joint][Quantity::kOutputPosition][sample];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    data->qpos[i] = position(i, 1);
    data->qvel[i] = (position(i, 2) - position(i, 0)) / (run.time_s[2] - run.time_s[0]);
  }
  double squares = 0.0, count = 0.0;
  std::size_t sample = 1;
  while (sample + 2 < run.time_s.size()) {
    const double now_s = run.time_s[1] + data->time;
    while (sample + 2 < run.time_s.size() && run.time_s[sample + 1] <= now_s + 1e-9) {
      ++sample;
      if (run.time_s[sample] < run.time_s[1] + 0.5) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        squares += std::pow(data->qpos[i] - position(i, sample), 2);
        ++count;
      }
    }
    const double share =
        (now_s - run.time_s[sample]) / (run.time_s[sample + 1] - run.time_s[sample]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<double>& command = run.joints[i][Quantity::kCommandedPosition];
      data->ctrl[i] = command[sample] + share * (command[sample + 1] - command[sample]);
    }
    mj_step(model.get(), data.get());
  }
  return std::sqrt(squares / count);
}

// Oracle: MuJoCo. The file that is written for it leaves there what our own simulation of the
// document, read back, promised: its base is welded as in the log, and friction is soft there.
TEST(RobotFiles, LeaveInMuJoCoWhatWasPromised) {
  std::vector<LegJoint> truth = kStated;
  truth[2].friction_Nm = 0.45;
  const Read read = read_leg(kStated, truth);
  const test::ScratchFolder folder;
  const io::Document nominal =
      io::read_document(folder.write("leg.json", test::leg_json(kStated).dump()), "robot");
  RobotModel fitted = read.model;
  for (const FreeValue& each : free_values(fitted)) {
    if (each.joint == 2 && each.name == "coulomb_Nm") set_value(fitted, each, 0.3);
    if (each.joint == 2 && each.of == FreeValue::Of::kRotor) set_value(fitted, each, 0.03);
  }
  io::Document document = nominal;
  document.root = nlohmann::json::parse(fitted_robot(nominal, read.rig, fitted, {}).dump());
  const hopper::Robot robot = hopper::robot_of(std::move(document)).robot;
  EXPECT_EQ(robot.tree.bodies[3].joint.passive.dry_friction, 0.3);
  const RobotModel back = model_of_robot(robot, read.rig, fitted.controllers);
  const Rollout promised = roll_out(read.log, back, {1e3, 0.5, 10, false});
  std::string mjcf = find_robot_output("mujoco")->write(
      {robot, read.rig.load.robot->bodies, back.controllers, {"a line"}});
  const std::string free = "<freejoint/>";
  ASSERT_NE(mjcf.find(free), std::string::npos) << mjcf;
  mjcf.erase(mjcf.find(free), free.size());
  ASSERT_EQ(read.log.runs.size(), 2u);
  const double train_rad = left_in_engine_rad(mjcf, read.log.runs[0]);
  EXPECT_GT(promised.train.all_rad, 2e-3);
  EXPECT_NEAR(train_rad, promised.train.all_rad, 0.05 * promised.train.all_rad);
  const double holdout_rad = left_in_engine_rad(mjcf, read.log.runs[1]);
  EXPECT_NEAR(holdout_rad, promised.holdout.all_rad, 0.05 * promised.holdout.all_rad);
  for (const RobotOutput& each : robot_outputs()) {
    const std::string text =
        each.write({robot, read.rig.load.robot->bodies, back.controllers, {"a line"}});
    EXPECT_NE(text.find("a line"), std::string::npos) << each.name;
    EXPECT_NE(text.find("0.03"), std::string::npos) << each.name;
    EXPECT_NE(text.find("calf_joint"), std::string::npos) << each.name;
  }
}

// Oracle: Python and its XML reader, which take the files whatever joints are called.
TEST(RobotFiles, StandWhateverJointsAreCalled) {
  if (std::system("python3 -c 'import ast' 2>/dev/null") != 0) {
    GTEST_SKIP() << "python3 is not installed";
  }
  const Read read = read_leg(kStated, kStated);
  const test::ScratchFolder folder;
  RobotSubject subject{
      hopper::robot_of(
          io::read_document(folder.write("leg.json", test::leg_json(kStated).dump()), "robot"))
          .robot,
      read.rig.load.robot->bodies,
      read.model.controllers,
      {"a -- line\nof two"}};
  subject.robot.tree.bodies[3].joint.name = "knee \"<left> -- \\1";
  for (const RobotOutput& each : robot_outputs()) {
    const std::string text = each.write(subject);
    const bool is_xml = text.starts_with('<');
    const std::string file = folder.write(std::string(each.name), text).string();
    const std::string reader = is_xml
                                   ? "import sys, xml.etree.ElementTree as e; e.parse(sys.argv[1])"
                                   : "import sys, ast; ast.parse(open(sys.argv[1]).read())";
    EXPECT_EQ(std::system(("python3 -c '" + reader + "' " + file).c_str()), 0) << each.name << "\n"
                                                                               << text;
  }
}

}  // namespace
}  // namespace torquewright::identification
