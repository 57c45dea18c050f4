// SPDX-License-Identifier: Apache-2.0
// Oracles: inverse dynamics with the torques and forces that were found; the check's torques of a
// robot at rest, found without any program; the drives themselves, which cut what is outside.
#include "hopper/tracking/operational/osc.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "hopper/replay/powered_drives.hpp"
#include "hopper/tracking/linearisation.hpp"
#include "hopper/tracking/operational/tasks_spec.hpp"
#include "hopper/tracking/operational/torque_program.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class Osc : public testing::Test {
 protected:
  void SetUp() override { reference.at(0.0, wanted); }

  /// The program of one look at a state, all points of the foot to stand.
  optimization::QuadraticStatus solve(const VectorXd& position, const VectorXd& velocity,
                                      const TorqueBounds& bounds) {
    EXPECT_TRUE(frame.set(wanted, touches, position, velocity));
    frame.rows(tasks.tasks, rows);
    const VectorXd asked = rows.acceleration + rows.stiffness_1_s2.cwiseProduct(rows.place_error) +
                           rows.damping_1_s.cwiseProduct(rows.rate_error);
    return program.solve(frame, rows, asked, touches, bounds);
  }
  TorqueBounds within(double torque_Nm) const {
    return {VectorXd::Constant(3, -torque_Nm), VectorXd::Constant(3, torque_Nm)};
  }
  VectorXd off_reference() const {
    VectorXd bent = wanted.position;
    bent.tail(3) += (VectorXd(3) << 0.05, -0.03, 0.02).finished();
    return bent;
  }

  Robot robot = test::robot_of("hopper.json");
  Reference reference = test::standing(robot, test::crouch(robot), 1.0);
  ReferenceInstant wanted;
  OperationalTasks tasks = usual_tasks(robot);
  TouchingPoints touches = TouchingPoints::Constant(4, true);
  TaskFrame frame{robot};
  TaskRows rows;
  TorqueProgram program{robot, tasks};
};

TEST_F(Osc, MovesAsTheDynamicsSay) {
  VectorXd velocity = VectorXd::Constant(9, 0.2);
  ASSERT_EQ(solve(off_reference(), velocity, within(300.0)),
            optimization::QuadraticStatus::kSolved);
  VectorXd needed(9);
  frame.body().inverse_dynamics(program.acceleration(), needed);
  const ContactRows points = contact_rows(robot, frame.body().state(), touches);
  const VectorXd given = drive_jacobian(frame.body()).transpose() * program.torque_Nm() +
                         points.jacobian.transpose() * program.contact_N();
  EXPECT_LE((given - needed).norm(), 1e-9 * (1.0 + needed.norm()));
  for (Index point = 0; point < 4; ++point) {
    const Eigen::Vector3d force_N = program.contact_N().segment<3>(3 * point);
    EXPECT_GE(force_N.z(), -1e-6);
    EXPECT_LE(force_N.head<2>().norm(), 0.9 * 0.6 * force_N.z() + 1e-6);
  }
  EXPECT_GT(program.contact_N().norm(), 20.0);
}

// At rest in the motion's posture the torques are those that hold it: the whole foot carries a
// wrench that the weight decides.
TEST_F(Osc, HoldsARestingRobotByTheChecksTorques) {
  ASSERT_EQ(solve(wanted.position, VectorXd::Zero(9), within(300.0)),
            optimization::QuadraticStatus::kSolved);
  // Effort is priced: 1e-4 of what costs 1 m/s^2.
  EXPECT_LE((program.torque_Nm() - wanted.drive_Nm).norm(), 1e-3 * wanted.drive_Nm.norm());
  EXPECT_GT(wanted.drive_Nm.norm(), 10.0);
  EXPECT_LE(program.acceleration().norm(), 0.01);
}

// Less torque than gravity asks for: it is at its bound, and the robot sinks.
TEST_F(Osc, StaysInTheDrivesBounds) {
  const double knee_Nm = std::abs(wanted.drive_Nm[0]);
  ASSERT_GT(knee_Nm, 10.0);
  TorqueBounds bounds = within(300.0);
  bounds.least_Nm[0] = -0.5 * knee_Nm;
  bounds.greatest_Nm[0] = 0.5 * knee_Nm;
  ASSERT_EQ(solve(wanted.position, VectorXd::Zero(9), bounds),
            optimization::QuadraticStatus::kSolved);
  EXPECT_NEAR(std::abs(program.torque_Nm()[0]), 0.5 * knee_Nm, 1e-9 * knee_Nm);
  const VectorXd off = rows.jacobian * program.acceleration() + rows.bias - rows.acceleration;
  EXPECT_GT(off.norm(), 0.1);
  // A drive that turns too fast for any torque of one sign: 0 is not allowed.
  bounds.least_Nm[1] = 5.0;
  ASSERT_EQ(solve(wanted.position, VectorXd::Zero(9), bounds),
            optimization::QuadraticStatus::kSolved);
  EXPECT_GE(program.torque_Nm()[1], 5.0 - 1e-9);
  bounds.least_Nm[1] = -300.0;
  bounds.greatest_Nm[1] = -5.0;
  ASSERT_EQ(solve(wanted.position, VectorXd::Zero(9), bounds),
            optimization::QuadraticStatus::kSolved);
  EXPECT_LE(program.torque_Nm()[1], -5.0 + 1e-9);
}

/// In its own engine, without motors.
struct Stood {
  double height_m = 0.0, tilt_rad = 0.0, outside_Nm = 0.0;
  ControlAccount account;
};
Stood stand(const Robot& robot, const Reference& reference,
            const std::shared_ptr<const OperationalTasks>& tasks, const VectorXd& velocity) {
  const PoweredDriveOptions options;
  TrackingOptions tracking;
  tracking.impact.handling = ImpactHandling::kDefault;
  const auto osc =
      operational_controller(robot, reference, tasks, drive_ranges(robot, options), tracking);
  test::ClosedLoop loop(robot, *osc, {1e-3, 4});
  ReferenceInstant first;
  reference.at(0.0, first);
  loop.start(first.position, velocity, 0.0);
  PoweredDrives drives(robot, options);
  WholeBody body(robot);
  Stood out;
  EXPECT_TRUE(loop.run_until(1.0, [&] {
    VectorXd speed(3), position(3);
    EXPECT_TRUE(body.set(loop.position(), loop.velocity()));
    body.speed_changes(loop.velocity(), speed);
    body.drive_positions(position);
    // Half a period after the look: at that look's speeds it was inside.
    const DriveStep& made = drives.drive(loop.torque_Nm(), position, speed, 1e-6);
    out.outside_Nm = std::max(out.outside_Nm, made.cut_off_Nm.cwiseAbs().maxCoeff());
  }));
  out.height_m = loop.position()[2] - first.position[2];
  out.tilt_rad = 2.0 * (loop.position().segment<4>(3) - first.position.segment<4>(3)).norm();
  out.account = osc->account();
  return out;
}

TEST_F(Osc, StandsAndBearsAPush) {
  const auto usual = std::make_shared<const OperationalTasks>(tasks);
  VectorXd velocity = VectorXd::Zero(9);
  velocity[0] = 0.05;  // The whole robot, foot included, as after a push.
  const Stood stood = stand(robot, reference, usual, velocity);
  EXPECT_LE(std::abs(stood.height_m), 0.005);
  EXPECT_LE(stood.tilt_rad, 0.02);
  EXPECT_LE(stood.outside_Nm, 1e-6);
  EXPECT_EQ(stood.account.looks, 1000);
  EXPECT_EQ(stood.account.unsolved, 0);
}

// Two tasks that want the same thing and its opposite: what is left is shared by their weights, and
// said.
TEST_F(Osc, SaysWhatIsLeftOfTasksThatContradict) {
  OperationalTasks both;
  both.tasks = {{.kind = TaskKind::kJoint, .of = 1, .weight = 3.0, .frequency_rad_s = 10.0},
                {.kind = TaskKind::kJoint, .of = 1, .weight = 1.0, .frequency_rad_s = 25.0}};
  TorqueProgram other(robot, both);
  ASSERT_TRUE(frame.set(wanted, touches, off_reference(), VectorXd::Zero(9)));
  frame.rows(both.tasks, rows);
  const VectorXd asked = rows.stiffness_1_s2.cwiseProduct(rows.place_error);
  ASSERT_EQ(other.solve(frame, rows, asked, touches, within(300.0)),
            optimization::QuadraticStatus::kSolved);
  const VectorXd off = rows.jacobian * other.acceleration() - asked;
  // 3 off_0 + 1 off_1 = 0 where nothing else pulls.
  EXPECT_NEAR(3.0 * off[0] + off[1], 0.0, 0.01 * std::abs(off[1]));
  EXPECT_GT(std::abs(off[1]), 1.0);
}

io::Document document(const std::string& keys) {
  return io::check_document(
      nlohmann::json::parse(R"({"kind": "controller", "version": 1, )" + keys + "}"), "controller",
      "tasks.json", "");
}

std::string refusal(const std::string& keys, const Robot& robot) {
  try {
    (void)tasks_of(document(keys), robot);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

TEST_F(Osc, ReadsItsTasks) {
  const OperationalTasks read =
      tasks_of(document(R"("robot": "one-legged hopper", "friction_share": 0.5, "tasks": [
        {"task": "center_of_mass", "along": ["z"], "when": "stance", "weight": 2},
        {"task": "joint", "joint": "ankle_roll", "frequency_rad_s": 7},
        {"task": "point", "contact": "toe_left", "damping_ratio": 3}])"),
               robot)
          .tasks;
  ASSERT_EQ(read.tasks.size(), 3u);
  EXPECT_EQ(read.tasks[0].along, (std::array<bool, 3>{false, false, true}));
  EXPECT_EQ(read.tasks[0].when, TaskTime::kStance);
  EXPECT_EQ(read.tasks[0].weight, 2.0);
  EXPECT_EQ(robot.tree.bodies[read.tasks[1].of].joint.name, "ankle_roll");
  EXPECT_EQ(read.tasks[1].stiffness_1_s2(), 49.0);
  EXPECT_EQ(read.tasks[2].damping_1_s(), 60.0);
  EXPECT_EQ(robot.contacts[read.tasks[2].of].name, "toe_left");
  EXPECT_EQ(read.friction_share, 0.5);
}

TEST_F(Osc, RefusesByName) {
  const auto expect = [&](const std::string& keys, const std::string& sentence) {
    EXPECT_NE(refusal(keys, robot).find(sentence), std::string::npos)
        << refusal(keys, robot) << "\nlacks " << sentence;
  };
  const std::string fine = R"("tasks": [{"task": "base_attitude"}])";
  EXPECT_EQ(refusal(fine, robot), "");
  expect(fine + R"(, "robot": "Cassie")",
         R"(tasks.json#/robot: is for "Cassie", and the robot is "one-legged hopper")");
  expect(R"("tasks": [{"task": "joint", "joint": "kne"}])", "tasks.json#/tasks/0/joint: ");
  expect(R"("tasks": [{"task": "joint", "joint": "kne"}])", R"("knee")");
  expect(R"("tasks": [{"task": "joint"}])", R"(a "joint" task names its "joint")");
  expect(R"("tasks": [{"task": "point", "joint": "knee", "contact": "toe_left"}])",
         R"("joint" is for no "point" task)");
  expect(fine + R"(, "rigid_joints": ["knee"])",
         R"(tasks.json#/rigid_joints/0: "knee" has no spring)");
}

}  // namespace
}  // namespace torquewright::hopper
