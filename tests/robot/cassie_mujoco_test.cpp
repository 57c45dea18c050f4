// SPDX-License-Identifier: Apache-2.0
// Cassie as its makers' file has it (../shared/data/robots/agility_cassie; skipped where that is
// absent): leaf springs, Achilles rods between balls, plantar rods that are in line where the file
// puts its bodies. Oracle: MuJoCo on the same file without its meshes, its loops closed by Newton's
// method on its own gaps from the file's keyframe on.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "io/documents/document.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/robot/mujoco_loops.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What the rods' spins weigh, 4e-6 kg m2, of inertias of 0.1 and more; MuJoCo's N takes the least
// speeds, ours holds the spin.
constexpr double kOfRodsSpins = 1e-6;

std::filesystem::path cassie_file() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const std::filesystem::path data =
      variable != nullptr ? std::filesystem::path(variable)
                          : std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  return data / "robots/agility_cassie/cassie.xml";
}

std::string without_meshes(std::string text) {
  for (const char* part :
       {"<asset>[^]*</asset>", "<geom type=\"mesh\"[^>]*/>", " material=\"cassie\"",
        " meshdir=\"assets\"", " texturedir=\"assets\""}) {
    text = std::regex_replace(text, std::regex(part), "");
  }
  return text;
}

class Cassie : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(cassie_file())) {
      GTEST_SKIP() << "Cassie's file (../shared/data) is not here";
    }
    imported_ = read_mjcf(cassie_file().string(), {});
    std::ifstream file(cassie_file());
    text_ = without_meshes({std::istreambuf_iterator<char>(file), {}});
  }

  /// As its document is read again.
  Robot robot() const {
    Robot driven = imported_.robot;
    for (Drivetrain& drivetrain : driven.drivetrains) {
      drivetrain.actuator_files.assign(drivetrain.joints.size(),
                                       TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/d110a_ankle.json");
    }
    return robot_of(io::check_document(nlohmann::json::parse(robot_json(driven).dump()), "robot",
                                       "robot.json", ""))
        .robot;
  }

  /// A posture that the legs can have: their springs are turned by less than 0.15 rad.
  static VectorXd legs(const Robot& robot, oracles::Dice& dice) {
    VectorXd joints(static_cast<Index>(robot.tree.bodies.size()) - 1);
    std::map<std::string, double> knees_rad;  // by leg
    for (Index i = 0; i < joints.size(); ++i) {
      const dynamics::Joint& joint = robot.tree.bodies[static_cast<std::size_t>(i) + 1].joint;
      const std::string leg = joint.name.substr(0, joint.name.find('-'));
      const std::string part = joint.name.substr(leg.size() + 1);
      joints[i] = part == "shin"
                      ? test::uniform(dice, -0.1, 0.1)
                      : test::uniform(dice, joint.limits.position_min, joint.limits.position_max);
      if (part == "knee") knees_rad[leg] = joints[i] = test::uniform(dice, -2.2, -1.0);
      if (part == "tarsus") joints[i] = 0.227 - knees_rad[leg] + test::uniform(dice, -0.1, 0.1);
    }
    return joints;
  }

  Imported imported_;
  std::string text_;
};

TEST_F(Cassie, IsReadWithItsSpringsAndRods) {
  EXPECT_EQ(imported_.robot.followers.size(), 2u);
  for (const Follower& follower : imported_.robot.followers) EXPECT_EQ(follower.joints.size(), 3u);
  EXPECT_EQ(imported_.robot.drivetrains.size(), 2u);
  double sum_kg = imported_.robot.links_kg();
  for (const dynamics::Body& body : imported_.robot.tree.bodies) sum_kg += body.inertia.mass_kg;
  EXPECT_NEAR(sum_kg, test::MujocoLoops(text_, imported_.robot).total_mass_kg(), 1e-9);
}

TEST_F(Cassie, MovesAsMujocoMovesIt) {
  const Robot robot = this->robot();
  WholeBody body(robot);
  oracles::Dice dice(17);
  const Index size = robot.tree.velocity_size();
  double mass = 0, force = 0, gap_m = 0;
  for (int sample = 0; sample < 20; ++sample) {
    VectorXd q = dynamics::zero_position(robot.tree), v(size), a(size);
    const VectorXd joints = legs(robot, dice);
    q.tail(joints.size()) = joints;
    q.head<3>() = Eigen::Vector3d(0, 0, 1.0059301);
    for (Index i = 0; i < size; ++i) {
      v[i] = test::uniform(dice, -2, 2);
      a[i] = test::uniform(dice, -20, 20);
    }
    test::MujocoLoops mujoco(text_, robot);
    mujoco.leave_balls_undamped();
    mujoco.begin_at_keyframe(0);
    gap_m = std::max(gap_m, mujoco.close(joints));
    ASSERT_TRUE(body.set(q, v)) << body.unreached().what << " at " << joints.transpose() << ", gap "
                                << gap_m;
    MatrixXd ours(size, size);
    body.mass_matrix(ours);
    mass = std::max(mass, test::difference(ours, mujoco.mass_matrix()));
    VectorXd forces(size);
    body.inverse_dynamics(a, forces);
    const VectorXd theirs = mujoco.inverse_dynamics(v, a);
    force = std::max(force, (forces - theirs).cwiseAbs().maxCoeff() / theirs.cwiseAbs().maxCoeff());
  }
  std::printf("gap %.2g m, mass matrix %.2g, forces %.2g of the greatest\n", gap_m, mass, force);
  EXPECT_LE(gap_m, 1e-11);
  EXPECT_LE(mass, kOfRodsSpins);
  EXPECT_LE(force, kOfRodsSpins);
}

// Oracle: MuJoCo on what is written: all links stand where the file's own do.
TEST_F(Cassie, GoesOutAsItCameIn) {
  const Robot robot = this->robot();
  test::MujocoLoops out(mjcf_of(robot, {.closed_loops = true}).text, robot);
  WholeBody body(robot);
  oracles::Dice dice(5);
  const Index size = robot.tree.velocity_size();
  const VectorXd joints = legs(robot, dice);
  ASSERT_LE(out.close(joints), 1e-11);
  VectorXd q = dynamics::zero_position(robot.tree);
  q.tail(joints.size()) = joints;
  ASSERT_TRUE(body.set(q, VectorXd::Zero(size)));
  MatrixXd ours(size, size);
  body.mass_matrix(ours);
  EXPECT_LE(test::difference(ours, out.mass_matrix()), kOfRodsSpins);
}

}  // namespace
}  // namespace torquewright::hopper
