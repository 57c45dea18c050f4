// SPDX-License-Identifier: Apache-2.0
#include "identification/robot_plan/robot_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "identification/rig/joint_actuator_json.hpp"
#include "identification/robot_plan/motion_information.hpp"
#include "io/documents/document.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/identification/robot/legs.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification {
namespace {

struct Planned {
  RobotModel model;
  hopper::Robot robot;
};

Planned planned_of(const nlohmann::json& robot, nlohmann::json rig) {
  const test::ScratchFolder folder;
  rig["load"]["file"] = "robot.json";
  const auto robot_file = folder.write("robot.json", robot.dump());
  const Rig of = read_rig(io::read_document(folder.write("rig.json", rig.dump()), "rig"));
  std::vector<actuator::ReadActuator> drives;
  std::vector<const actuator::Actuator*> pointers;
  for (std::size_t i = 0; i < of.joints.size(); ++i) drives.push_back(actuator_of_joint(of, i));
  for (const auto& each : drives) pointers.push_back(&each.actuator);
  return {robot_model(of, pointers), hopper::read_robot(robot_file).robot};
}

TEST(CommandedMotion, BeginsAndEndsAtRestWithinItsReach) {
  std::mt19937_64 random(3);
  CommandedMotion motion{"a", 4.0, {{0.3, 0.5, {}}, {-1.0, 0.2, {}}}};
  draw_waves(motion, random);
  for (const JointCommand& joint : motion.joints) {
    const std::vector<double> command = command_rad(joint, motion.duration_s);
    ASSERT_EQ(command.size(), 801u);
    EXPECT_EQ(command.front(), joint.centre_rad);
    EXPECT_NEAR(command.back(), joint.centre_rad, 1e-12);
    EXPECT_NEAR(command[1], joint.centre_rad, 1e-3);  // at rest
    const auto [low, high] = std::minmax_element(command.begin(), command.end());
    EXPECT_LE(*high - joint.centre_rad, joint.reach_rad);
    EXPECT_LE(joint.centre_rad - *low, joint.reach_rad);
    EXPECT_GT(*high - *low, 0.5 * joint.reach_rad);
  }
}

// Oracle: the integral of a frequency that grows from 0.1 to 5 Hz by equal shares in equal times
// is 4.9 T/ln 50 turns, each with two zeros.
TEST(CommandedMotion, SweepsThroughAsManyTurnsAsItsFrequenciesSay) {
  CommandedMotion motion{"a", 20.0, {{0.0, 1.0, {}}}};
  sweep(motion);
  const std::vector<double> command = command_rad(motion.joints.front(), motion.duration_s);
  int zeros = 0;
  for (std::size_t i = 1; i < command.size(); ++i) zeros += command[i - 1] * command[i] < 0.0;
  EXPECT_NEAR(zeros, 2.0 * 4.9 * 20.0 / std::log(50.0), 1.0);
}

/// A wheel about the vertical axis, so that its weight does nothing.
nlohmann::json wheel_json() {
  nlohmann::json robot{{"kind", "robot"}, {"version", 1}, {"name", "wheel"}};
  robot["base"] = {{"body", "body"}, {"motion", "spatial"}};
  for (const char* name : {"body", "rim"}) {
    robot["bodies"].push_back({{"name", name},
                               {"mass_kg", 1},
                               {"center_of_mass_m", {0, 0, 0}},
                               {"inertia_kg_m2", {{"xx", 0.02}, {"yy", 0.02}, {"zz", 0.03}}}});
  }
  robot["joints"] = {{{"name", "wheel_joint"},
                      {"type", "revolute"},
                      {"parent", "body"},
                      {"child", "rim"},
                      {"position_m", {0, 0, 0}},
                      {"axis", {0, 0, 1}},
                      {"reflected_inertia_kg_m2", 0.02},
                      {"damping_Nm_s_rad", 0.3}}};
  return robot;
}

/// Squared slopes of a position under the law of leg_rig_json() by the damping and by the inertia,
/// summed: J q'' = k (r - q) - (d + b) q', and its derivatives, by Runge and Kutta.
std::pair<double, double> squared_slopes(const std::vector<double>& command) {
  constexpr double kStiffness = 20.0, kDamping = 0.5 + 0.3, kInertia = 0.03 + 0.02;
  using State = Eigen::Matrix<double, 6, 1>;  // position, speed; the same by damping, by inertia
  const auto rate = [&](const State& s, double told) {
    const auto bent = [&](double position, double speed, double pushed) {
      return (pushed - kStiffness * position - kDamping * speed) / kInertia;
    };
    const double acceleration = bent(s[0], s[1], kStiffness * told);
    State result;
    result << s[1], acceleration, s[3], bent(s[2], s[3], -s[1]), s[5],
        bent(s[4], s[5], -acceleration);
    return result;
  };
  State state = State::Zero();
  std::pair<double, double> sums;
  for (std::size_t i = 1; i < command.size(); ++i) {
    const double middle = 0.5 * (command[i - 1] + command[i]), h = kCommandStep_s;
    const State a = rate(state, command[i - 1]), b = rate(state + 0.5 * h * a, middle),
                c = rate(state + 0.5 * h * b, middle), d = rate(state + h * c, command[i]);
    state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    sums.first += state[2] * state[2];
    sums.second += state[4] * state[4];
  }
  return sums;
}

// Oracle: the linear loop's own differential equation and its derivatives, integrated here.
TEST(MotionInformation, IsThatOfTheLoopsOwnDerivatives) {
  nlohmann::json rig = test::leg_rig_json();
  const Planned wheel = planned_of(wheel_json(), rig);
  CommandedMotion motion{"a", 8.0, {{0.0, 0.6, {}}}};
  std::mt19937_64 random(1);
  draw_waves(motion, random);
  std::vector<FreeValue> values = free_values(wheel.model);
  std::erase_if(values, [](const FreeValue& each) {
    return each.name != "viscous_Nm_s_rad" && each.name != "rotor_inertia_kg_m2";
  });
  ASSERT_EQ(values.size(), 2u);
  constexpr double kNoise_rad = 1e-3;
  const Eigen::MatrixXd information = information_of(wheel.model, 0, values, motion, kNoise_rad);
  const auto [by_damping, by_inertia] =
      squared_slopes(command_rad(motion.joints.front(), motion.duration_s));
  for (std::size_t k = 0; k < 2; ++k) {
    const bool is_inertia = values[k].name == "rotor_inertia_kg_m2";
    const double per_size = values[k].size / kNoise_rad;
    const double expected = (is_inertia ? by_inertia : by_damping) * per_size * per_size;
    const auto i = static_cast<Eigen::Index>(k);
    // Slopes are differences over a twentieth of a size, of steps of 2 ms.
    EXPECT_NEAR(information(i, i), expected, 0.03 * expected) << values[k].name;
  }
}

/// Two legs that can meet, over the ground.
nlohmann::json legs_with_balls() {
  nlohmann::json robot =
      test::two_legs_json({{0.01, 0.2, 0.1}, {0.01, 0.2, 0.1}, {0.02, 0.2, 0.1}});
  for (nlohmann::json& joint : robot["joints"]) {
    const std::string name = joint["name"];
    if (name == "right_hip_joint") joint["position_m"] = {0.2, -0.1, 0};
    joint["range_rad"] =
        name.ends_with("calf_joint") ? nlohmann::json{-2.5, -0.5} : nlohmann::json{-1.0, 1.5};
    joint["torque_limit_Nm"] = 12;
  }
  for (const char* calf : {"left_calf", "right_calf"}) {
    robot["collision_spheres"].push_back(
        {{"body", calf}, {"center_m", {0, 0, -0.2}}, {"radius_m", 0.03}});
  }
  robot["postures"] = {{"stand",
                        {{"left_thigh_joint", 0.7},
                         {"left_calf_joint", -1.4},
                         {"right_thigh_joint", 0.7},
                         {"right_calf_joint", -1.4}}}};
  return robot;
}

RobotPlanOptions short_plan() {
  RobotPlanOptions options;
  options.duration_s = 2.0;
  options.runs = {"1"};
  options.candidates = 2;
  options.limits.base_height_m = 0.42;
  return options;
}

std::vector<double> standing(const Planned& legs) {
  std::vector<double> centre_rad;
  for (const std::size_t body : legs.model.load.robot->bodies)
    centre_rad.push_back(legs.robot.postures.front().joints[static_cast<Eigen::Index>(body) - 1]);
  return centre_rad;
}

/// A motion about that posture in which one joint moves.
CommandedMotion moving(const Planned& legs, std::size_t joint, double reach_rad) {
  CommandedMotion motion{"a", 2.0, {}};
  for (const double centre_rad : standing(legs)) motion.joints.push_back({centre_rad, 0.0, {}});
  motion.joints[joint].reach_rad = reach_rad;
  motion.joints[joint].waves = {{1.0, 0.5, 0.5, 0.0}};
  return motion;
}

// Oracle: the legs are alike and stand side by side, 0.15 m apart, however far they sag; their
// balls have radii of 0.03 m. A hip that rolls by 0.6 rad brings them together, and the ground is
// where the base's height puts it.
TEST(MotionRoom, IsMeasuredBetweenBodiesAndToTheGround) {
  const Planned legs = planned_of(legs_with_balls(), test::leg_rig_json());
  MotionLimits limits;
  limits.base_height_m = 0.42;
  const RoomOfMotion still = room_of(legs.model, legs.robot, limits, moving(legs, 0, 0.0));
  EXPECT_NEAR(still.room.bodies_m.left, 0.15 - 2.0 * 0.03, 1e-6);
  EXPECT_EQ(still.room.bodies_m.place, "left_calf and right_calf");
  EXPECT_EQ(std::count(still.goes_too_far.begin(), still.goes_too_far.end(), true), 0);
  limits.base_height_m = 0.52;
  const RoomOfMotion higher = room_of(legs.model, legs.robot, limits, moving(legs, 0, 0.0));
  EXPECT_NEAR(higher.room.ground_m.left - still.room.ground_m.left, 0.1, 1e-12);
  const RoomOfMotion rolled = room_of(legs.model, legs.robot, limits, moving(legs, 0, 0.6));
  EXPECT_LT(rolled.room.bodies_m.left, 0.01);
  EXPECT_TRUE(rolled.goes_too_far[0]);
}

// Oracle: the limits themselves, measured again on the motion that is written.
TEST(RobotPlan, KeepsWithinLimitsAndClearOfBodiesAndGround) {
  const Planned legs = planned_of(legs_with_balls(), test::leg_rig_json());
  RobotPlanOptions options = short_plan();
  options.candidates = 1;
  const RobotPlan plan = plan_robot(legs.model, legs.robot, standing(legs), options);
  ASSERT_EQ(plan.motions.size(), 1u);
  const RoomOfMotion again = room_of(legs.model, legs.robot, options.limits, plan.motions.front());
  EXPECT_EQ(std::count(again.goes_too_far.begin(), again.goes_too_far.end(), true), 0);
  for (const Room* room : {&again.room.position_rad, &again.room.torque_share, &again.room.bodies_m,
                           &again.room.ground_m})
    EXPECT_GT(room->left, 0.0) << room->place;
  EXPECT_EQ(again.room.bodies_m.left, plan.room.bodies_m.left);
}

// Oracle: information adds up: no value is told worse by two runs than by the first of them, which
// the same seed draws again.
TEST(RobotPlan, TellsMoreByMoreRuns) {
  const nlohmann::json robot =
      test::leg_json({{0.01, 0.2, 0.1}, {0.01, 0.2, 0.1}, {0.02, 0.2, 0.1}});
  const Planned leg = planned_of(robot, test::leg_rig_json());
  const std::vector<double> centre_rad = {0.0, 0.7, -1.4};
  RobotPlanOptions options = short_plan();
  const RobotPlan one = plan_robot(leg.model, leg.robot, centre_rad, options);
  options.runs = {"1", "2"};
  options.duration_s = 4.0;
  const RobotPlan two = plan_robot(leg.model, leg.robot, centre_rad, options);
  ASSERT_EQ(one.values.size(), two.values.size());
  for (std::size_t k = 0; k < one.values.size(); ++k) {
    const double error = two.values[k].by_plan.standard_error;
    EXPECT_LE(error, one.values[k].by_plan.standard_error * (1.0 + 1e-9));
    EXPECT_LE(error, two.values[k].by_plan.which.deviation);
  }
  EXPECT_EQ(one.motions.front().joints.front().waves.front().phase_rad,
            two.motions.front().joints.front().waves.front().phase_rad);
  const auto told = std::count_if(two.values.begin(), two.values.end(),
                                  [](const auto& each) { return each.by_plan.is_told(); });
  EXPECT_GT(told, 0);
}

TEST(RobotPlan, RefusesAPlaceWhereTheRobotCannotStand) {
  const Planned legs = planned_of(legs_with_balls(), test::leg_rig_json());
  RobotPlanOptions options = short_plan();
  options.limits.base_height_m = 0.2;
  const std::string said =
      test::refusal([&] { plan_robot(legs.model, legs.robot, standing(legs), options); });
  EXPECT_NE(said.find("--posture: the robot cannot stand where its motion is to begin"),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("inf"), std::string::npos) << said;
  EXPECT_NE(said.find("m are left to the ground (left_calf)"), std::string::npos) << said;
}

}  // namespace
}  // namespace torquewright::identification
