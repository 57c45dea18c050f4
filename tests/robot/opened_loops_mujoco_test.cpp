// SPDX-License-Identifier: Apache-2.0
// <connect> read into mechanisms. Oracle: MuJoCo on the same file, its loops closed by Newton's
// method on its own gaps: cranks' places, and their ratios by its own constraint Jacobian, beside
// the mechanisms' closed forms; and its mass matrix of the closed loops beside ours.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "dynamics/rigid_inertia.hpp"
#include "io/documents/document.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/mechanisms/four_bar.hpp"
#include "robot/mechanisms/parallel_ankle.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/dynamics/random_tree.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/mujoco_loops.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Newton's method leaves 1e-14 m; over levers of centimetres, through the sine of the least angle
// between links, and of the second order in the inertias.
constexpr double kAsClosedForm = 1e-9;
constexpr double kNoLimit = std::numeric_limits<double>::infinity();
const std::string kExample = TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json";

Imported read_text(const std::string& text, const ImportFileOptions& options = {}) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", text), options);
}

/// As `robot import --actuator` makes it: through its document, with this actuator everywhere.
Robot with_actuators(Robot robot) {
  for (Drivetrain& drivetrain : robot.drivetrains) {
    drivetrain.actuator_files.assign(drivetrain.joints.size(),
                                     TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/d110a_ankle.json");
  }
  const std::string text = robot_json(robot).dump();
  return robot_of(io::check_document(nlohmann::json::parse(text), "robot", "robot.json", "")).robot;
}

ImportFileOptions massless() {
  ImportFileOptions options;
  options.drops_link_mass = true;
  return options;
}

std::string refusal(const std::string& text) {
  try {
    (void)read_text(text);
    return "was read";
  } catch (const io::SpecError& error) {
    return error.what();
  }
}

double joint_min(const Robot& robot, Index joint) {
  return robot.tree.bodies[static_cast<std::size_t>(joint) + 1].joint.limits.position_min;
}

double joint_max(const Robot& robot, Index joint) {
  return robot.tree.bodies[static_cast<std::size_t>(joint) + 1].joint.limits.position_max;
}

VectorXd random_joints(oracles::Dice& dice, const Robot& robot) {
  VectorXd joints(static_cast<Index>(robot.tree.bodies.size()) - 1);
  for (Index i = 0; i < joints.size(); ++i) {
    const bool has_range = std::isfinite(joint_min(robot, i));
    joints[i] = has_range ? test::uniform(dice, joint_min(robot, i), joint_max(robot, i))
                          : test::uniform(dice, -1, 1);
  }
  return joints;
}

MatrixXd mass_matrix_of(const Robot& robot, const VectorXd& joints) {
  WholeBody body(robot);
  VectorXd q = dynamics::zero_position(robot.tree);
  q.tail(joints.size()) = joints;
  const Index size = robot.tree.velocity_size();
  if (!body.set(q, VectorXd::Zero(size))) throw std::runtime_error("is not reached");
  MatrixXd mass(size, size);
  body.mass_matrix(mass);
  return mass;
}

/// Of one drivetrain at a posture of all joints.
Transfer transfer_at(const Drivetrain& drivetrain, const VectorXd& joints) {
  SmallVector own(static_cast<Index>(drivetrain.joints.size()));
  for (Index i = 0; i < own.size(); ++i) {
    own[i] = joints[static_cast<Index>(drivetrain.joints[static_cast<std::size_t>(i)]) - 1];
  }
  return drivetrain.mechanism->transfer(own, SmallVector::Zero(own.size())).value();
}

// Oracle: the document that the file was written from.
TEST(OpenedLoops, OfOurOwnExportAreTheMechanismsTheyWere) {
  Robot robot = read_robot(kExample).robot;
  for (const bool has_actuators : {true, false}) {
    if (!has_actuators) {  // else motors with the joints' torque limits turn these themselves
      for (dynamics::Body& body : robot.tree.bodies) body.joint.limits.effort_max = kNoLimit;
    }
    const std::string text = mjcf_of(robot, {has_actuators, true, true, true}).text;
    const Robot again = with_actuators(read_text(text, massless()).robot);
    ASSERT_EQ(again.drivetrains.size(), 2u);
    ASSERT_EQ(again.tree.bodies.size(), robot.tree.bodies.size());
    const auto& bar = dynamic_cast<const FourBar&>(*again.drivetrains[0].mechanism).geometry();
    const auto& was = dynamic_cast<const FourBar&>(*robot.drivetrains[0].mechanism).geometry();
    EXPECT_NEAR(bar.crank_m, was.crank_m, kAsClosedForm);
    EXPECT_NEAR(bar.coupler_m, was.coupler_m, kAsClosedForm);
    EXPECT_NEAR(bar.rocker_m, was.rocker_m, kAsClosedForm);
    EXPECT_NEAR(bar.ground_m, was.ground_m, kAsClosedForm);
    EXPECT_NEAR(bar.crank_zero_rad, was.crank_zero_rad, kAsClosedForm);
    EXPECT_NEAR(bar.rocker_zero_rad, was.rocker_zero_rad, kAsClosedForm);
    EXPECT_TRUE(again.drivetrains[0].mechanism->constant_jacobian().has_value());
    const std::vector<std::string> names =
        has_actuators ? robot.drivetrains[1].actuator_names
                      : std::vector<std::string>{"ankle_left_crank", "ankle_right_crank"};
    EXPECT_EQ(again.drivetrains[1].actuator_names, names);
    oracles::Dice dice(5);
    double map = 0, ratio = 0, mass = 0;
    for (int sample = 0; sample < 50; ++sample) {
      const VectorXd joints = 0.95 * random_joints(dice, robot);
      for (std::size_t i = 0; i < 2; ++i) {
        const VectorXd zero = VectorXd::Zero(3);
        const Transfer ours = transfer_at(again.drivetrains[i], joints);
        const Transfer theirs = transfer_at(robot.drivetrains[i], joints);
        // A file's cranks count from where all joints are at zero.
        const SmallVector from = transfer_at(robot.drivetrains[i], zero).actuator_position_rad;
        const SmallVector apart = theirs.actuator_position_rad - from - ours.actuator_position_rad;
        map = std::max(map, apart.cwiseAbs().maxCoeff());
        ratio = std::max(ratio, (theirs.jacobian - ours.jacobian).cwiseAbs().maxCoeff());
      }
      mass = std::max(
          mass, test::difference(mass_matrix_of(again, joints), mass_matrix_of(robot, joints)));
    }
    std::printf("worst of 50 postures: cranks %.2g rad, ratios %.2g, mass matrix %.2g\n", map,
                ratio, mass);
    EXPECT_LE(map, 1e-10);
    EXPECT_LE(ratio, 1e-10);
    EXPECT_LE(mass, 1e-10);
  }
}

/// A loop as others write it; MuJoCo 2.2.2 knows no sites in a connect, for it they are an anchor.
struct Foreign {
  const char* name;
  std::string ours;
  std::string theirs = {};
  std::vector<std::string> cranks;  ///< Joints, in the order of the drives.
  std::vector<std::string> links;   ///< Bodies.
};

std::ostream& operator<<(std::ostream& out, const Foreign& one) { return out << one.name; }

const std::string kHead = R"(<mujoco><compiler angle="radian"/><worldbody>
  <body name="trunk" pos="0.1 0.2 1"><freejoint/>
  <inertial pos="0.01 0.02 0.03" mass="6" diaginertia="0.08 0.07 0.05"/>)";
const std::string kFoot =
    R"(<inertial pos="0.02 0.01 -0.1" mass="1.5" quat="0.6 0.8 0 0" diaginertia="0.02 0.03 0.015"/>)";
const std::string kLink =
    R"(<inertial pos="0.01 0.005 -0.02" mass="0.01" diaginertia="1e-5 1.2e-5 0.9e-5"/>)";

std::string motor(const std::string& joint) {
  return R"(<motor name="drive_)" + joint + R"(" joint=")" + joint + R"("/>)";
}

std::string closed(const std::string& bodies, const std::string& connects,
                   const std::string& motors) {
  return kHead + bodies + "</body></worldbody><equality>" + connects + "</equality><actuator>" +
         motors + "</actuator></mujoco>";
}

// Four-bars in the plane across (0, 0.6, 0.8): frames turned, joints beside their bodies' origins.
const std::string kAxis = R"(axis="0 0.6 0.8")";
const std::string kKnee =
    R"(<body name="shank" pos="0.02 0.03 -0.3">
    <joint name="knee" )" +
    kAxis + R"( pos="0.01 0 0.02" limited="true" range="-0.5 0.7" ref="0.1"/>)" + kFoot;

std::vector<Foreign> foreign() {
  const std::string crank = R"(<body name="crank" pos="0.05 0.01 0.02">
    <joint name="c" axis="0 -0.6 -0.8" armature="0.02" ref="0.3"/>)" +
                            kLink;
  const std::string on_crank = crank + R"(<body name="rod" pos="0.06 0.008 -0.006">
    <joint name="r" )" + kAxis +
                               "/>" + kLink + "</body></body>" + kKnee + "</body>";
  const std::string on_rocker = crank + "</body>" + kKnee +
                                R"(<body name="rod" pos="0.08 0.04 -0.03">
    <joint name="r" axis="0 -0.6 -0.8"/>)" +
                                kLink + "</body></body>";
  const std::string balls =
      crank + R"(<body name="rod" pos="0.06 0.03 0.02"><joint name="r" type="ball"/>)" + kLink +
      "</body></body>" + kKnee + "</body>";
  // The rod's far end is where the shank's point is; (0.07, 0.04, -0.03) is across the axis.
  const std::string to_shank = R"(<connect body1="shank" body2="rod" anchor="0.08 0.04 -0.03"/>)";
  const std::string from_crank =
      R"(<connect body1="crank" body2="rod" anchor="0.06 0.008 -0.006"/>)";
  // Two cranks beside each other on the trunk, a universal joint at the foot, turned frames.
  const auto ankle_crank = [](const std::string& n, const std::string& y, const std::string& rod) {
    return R"(<body name="crank_)" + n + R"(" pos="0.01 )" + y + R"( -0.1" quat="0.96 0.28 0 0">
      <joint name="c)" +
           n + R"(" axis="0 0.8 -0.6" armature="0.03" ref="0.05"/>)" + kLink + rod + "</body>";
  };
  const auto rod_on_crank = [](const std::string& n, const std::string& joints) {
    return R"(<body name="rod_)" + n + R"(" pos="-0.06 0.005 0">)" + joints + kLink + "</body>";
  };
  const auto ball = [](const std::string& n) {
    return R"(<joint name="r)" + n + R"(" type="ball"/>)";
  };
  const auto universal = [](const std::string& n) {
    return R"(<joint name="r)" + n + R"(" axis="0 1 0"/><joint name="s)" + n +
           R"(" axis="1 0 0"/>)";
  };
  const std::string foot = R"(<body name="foot" pos="0 0 -0.4" quat="0.995 0 0.0998749217771909 0">
    <joint name="pitch" axis="0 1 0" limited="true" range="-0.4 0.3"/><joint name="roll" axis="1 0 0" limited="true" range="-0.3 0.35" pos="0 0 -0.01"/>)" +
                           kFoot;
  const std::string plain = foot + "</body>";
  const auto tied = [](const std::string& n, const std::string& y) {
    return R"(<connect body1="foot" body2="rod_)" + n + R"(" anchor="-0.05 )" + y + R"( 0.01"/>)";
  };
  const auto rod_on_foot = [&](const std::string& n, const std::string& y) {
    return R"(<body name="rod_)" + n + R"(" pos="-0.05 )" + y + R"( 0.01">)" + ball(n) + kLink +
           "</body>";
  };
  // Frames stand alike in the file's posture: where pins are is a matter of sums.
  const std::string with_sites =
      crank + R"(<body name="rod" pos="0.06 0.008 -0.006"><joint name="r" )" + kAxis + "/>" +
      kLink + R"(<site name="far" pos="-0.01 0.052 -0.344"/></body></body>)" + kKnee +
      R"(<site name="pin" pos="0.08 0.04 -0.03"/></body>)";
  return {
      {"FourBarRodOnCrank", closed(on_crank, to_shank, motor("c")), "", {"c"}, {"crank", "rod"}},
      {"FourBarRodOnRocker",
       closed(on_rocker, from_crank, motor("c")),
       "",
       {"c"},
       {"crank", "rod"}},
      {"FourBarRodBetweenBalls", closed(balls, to_shank, motor("c")), "", {"c"}, {"crank", "rod"}},
      {"AnkleBalls",
       closed(ankle_crank("1", "0.05", rod_on_crank("1", ball("1"))) +
                  ankle_crank("2", "-0.04", rod_on_crank("2", ball("2"))) + plain,
              tied("1", "0.05") + tied("2", "-0.04"), motor("c1") + motor("c2")),
       "",
       {"c1", "c2"},
       {"crank_1", "rod_1", "crank_2", "rod_2"}},
      {"AnkleUniversals",
       closed(ankle_crank("1", "0.05", rod_on_crank("1", universal("1"))) +
                  ankle_crank("2", "-0.04", rod_on_crank("2", universal("2"))) + plain,
              tied("1", "0.05") + tied("2", "-0.04"), motor("c1") + motor("c2")),
       "",
       {"c1", "c2"},
       {"crank_1", "rod_1", "crank_2", "rod_2"}},
      {"AnkleRodsOnTheFoot",
       closed(ankle_crank("1", "0.05", "") + ankle_crank("2", "-0.04", "") + foot +
                  rod_on_foot("1", "0.05") + rod_on_foot("2", "-0.04") + "</body>",
              R"(<connect body1="crank_1" body2="rod_1" anchor="-0.06 0.005 0"/>
                 <connect body1="crank_2" body2="rod_2" anchor="-0.06 0.005 0"/>)",
              motor("c1") + motor("c2")),
       "",
       {"c1", "c2"},
       {"crank_1", "rod_1", "crank_2", "rod_2"}},
      {"FourBarBySites",
       closed(with_sites, R"(<connect site1="far" site2="pin" solref="0.005 1"/>)", motor("c")),
       closed(on_crank, to_shank, motor("c")),
       {"c"},
       {"crank", "rod"}},
  };
}

class OpenedLoop : public testing::TestWithParam<Foreign> {};

TEST_P(OpenedLoop, MovesAsMujocoClosesIt) {
  const Foreign& one = GetParam();
  const Robot robot = with_actuators(read_text(one.ours, massless()).robot);
  const std::string& theirs = one.theirs.empty() ? one.ours : one.theirs;
  oracles::Dice dice(17);
  double gap = 0, place = 0, ratio = 0, mass = 0, least = 1e9, most = -1e9;
  for (int sample = 0; sample < 12; ++sample) {
    test::MujocoLoops mujoco(theirs, robot);
    for (const std::string& body : one.links) mujoco.weigh_nothing(body);
    const VectorXd joints = random_joints(dice, robot);
    gap = std::max(gap, mujoco.close(joints));
    const Drivetrain& drivetrain = robot.drivetrains.at(0);
    const Transfer ours = transfer_at(drivetrain, joints);
    for (std::size_t i = 0; i < one.cranks.size(); ++i) {
      const auto row = static_cast<Index>(i);
      const double apart = mujoco.position(one.cranks[i]) - ours.actuator_position_rad[row];
      place = std::max(place, std::abs(std::remainder(apart, 2 * std::numbers::pi)));
      ratio = std::max(
          ratio, (mujoco.ratios(one.cranks[i]) - ours.jacobian.row(row)).cwiseAbs().maxCoeff());
      least = std::min(least, ours.jacobian(row, 0));
      most = std::max(most, ours.jacobian(row, 0));
    }
    mass = std::max(mass, test::difference(mass_matrix_of(robot, joints), mujoco.mass_matrix()));
  }
  std::printf("gap %.2g m, cranks %.2g rad, ratios %.2g (%.3g to %.3g), mass matrix %.2g\n", gap,
              place, ratio, least, most, mass);
  EXPECT_LE(gap, 1e-12);
  EXPECT_LE(place, kAsClosedForm);
  EXPECT_LE(ratio, kAsClosedForm);
  EXPECT_LE(mass, kAsClosedForm);
  EXPECT_GT(most - least, 0.05) << "a ratio that does not change shows little";
}

double share_of_energy_off(const MatrixXd& ours, const MatrixXd& theirs) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> motions(ours - theirs, theirs);
  return motions.eigenvalues().cwiseAbs().maxCoeff();
}

// Oracle: MuJoCo's mass matrix with the links' mass. What they weigh is not held exactly; by how
// little it is off is what the import promises.
TEST_P(OpenedLoop, HoldsTheMassOfItsLinksAsSaid) {
  const Foreign& one = GetParam();
  const ImportFileOptions options;
  const Robot robot = with_actuators(read_text(one.ours, options).robot);
  const std::string& theirs = one.theirs.empty() ? one.ours : one.theirs;
  double total_kg = 0;
  for (const dynamics::Body& body : robot.tree.bodies) total_kg += body.inertia.mass_kg;
  EXPECT_NEAR(total_kg, test::MujocoLoops(theirs, robot).total_mass_kg(), 1e-12);
  oracles::Dice dice(18);
  double off = 0;
  for (int sample = 0; sample < 12; ++sample) {
    test::MujocoLoops mujoco(theirs, robot);
    const VectorXd joints = random_joints(dice, robot);
    (void)mujoco.close(joints);
    off = std::max(off, share_of_energy_off(mass_matrix_of(robot, joints), mujoco.mass_matrix()));
  }
  std::printf("kinetic energy off by at most %.2g\n", off);
  EXPECT_LE(off, options.greatest_link_error);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  if (at == std::string::npos) throw std::runtime_error("there is no " + what);
  return text.replace(at, what.size(), by);
}

TEST(OpenedLoops, ThatAreNoMechanismAreRefusedAndWhySaid) {
  const std::string bar = foreign().front().ours;
  const std::string ankle = foreign()[4].ours;
  const std::vector<std::array<std::string, 2>> refused{
      {replaced(bar, "<joint name=\"r\"", "<joint type=\"slide\" name=\"r\""), "\"r\" slides"},
      {replaced(bar, "</actuator>", motor("knee") + "</actuator>"), "drives turn both ends"},
      {replaced(bar, "</actuator>", motor("r") + "</actuator>"), "a drive turns its rod"},
      {replaced(bar, motor("c"), ""), "which one is the crank is open"},
      {replaced(bar, "<connect ", "<connect wobble=\"1\" "), "wobble of <connect> is not known"},
      {replaced(bar, "body2=\"rod\"", ""), "a loop over the world"},
      {replaced(bar, "body2=\"rod\"", "body2=\"trunk\""), "no linkage that is read"},
      {replaced(bar, "axis=\"0 -0.6 -0.8\"", "axis=\"0.1 -0.6 -0.8\""), "are not parallel"},
      {replaced(ankle, "<connect body1=\"foot\" body2=\"rod_2\"",
                "<connect active=\"false\" body1=\"foot\" body2=\"rod_2\""),
       "1 rods move joints \"pitch\" and \"roll\""}};
  for (const auto& [text, message] : refused) {
    const std::string said = refusal(text);
    EXPECT_NE(said.find(message), std::string::npos) << message << "\n" << said;
  }
}

// What general_loops_mujoco_test.cpp holds against MuJoCo.
TEST(OpenedLoops, ThatAreNoMechanismOfClosedFormAreKeptAndWhySaid) {
  const std::string bar = foreign().front().ours;
  const std::vector<std::array<std::string, 2>> kept{
      {replaced(bar, "<joint name=\"r\"", "<joint stiffness=\"9\" name=\"r\""),
       "a spring in the linkage, at joint \"r\""},
      {replaced(bar, "joint=\"c\"", "joint=\"knee\""), "and the linkage only follows it"},
      {replaced(bar, "mass=\"0.01\"", "mass=\"1.6\""), "weighs more than \"shank\""},
      {replaced(bar, "mass=\"0.01\"", "mass=\"0.6\""), "more than 0.01 (--link-error"},
      {replaced(bar, "<body name=\"rod\"",
                "<body name=\"x\"><joint/>" + kFoot + "</body><body name=\"rod\""),
       "whose body carries more than a crank does"}};
  for (const auto& [text, message] : kept) {
    const Imported read = read_text(text);
    const bool is_said =
        std::any_of(read.notes.begin(), read.notes.end(), [&](const std::string& note) {
          return note.find("is kept as a loop of its own bodies") != std::string::npos &&
                 note.find(message) != std::string::npos;
        });
    EXPECT_TRUE(is_said) << message;
  }
}

/// A leg whose rod runs from the hip over knee, spring-loaded shin and tarsus to a heel that is a
/// leaf spring, as one public biped has it; places and masses are made up.
TEST(OpenedLoops, OverLeafSpringsAreRefusedByTheirName) {
  const std::string text = closed(
      R"(<body name="achilles_rod" pos="0 0 0.045"><joint name="rod" type="ball"/>)" + kLink +
          R"(</body><body name="knee" pos="0.12 0 0"><joint name="knee" axis="0 1 0"/>)" + kFoot +
          R"(<body name="shin" pos="0.06 0 -0.05"><joint name="shin" axis="0 1 0" stiffness="1500"/>)" +
          kFoot + R"(<body name="tarsus" pos="0.02 0 -0.4"><joint name="tarsus" axis="0 1 0"/>)" +
          kFoot +
          R"(<body name="heel_spring" pos="-0.03 0 0"><joint name="heel" axis="0 1 0" stiffness="1250"/>)" +
          kLink + "</body></body></body></body>",
      R"(<connect body1="achilles_rod" body2="heel_spring" anchor="0 0 -0.5"/>)", motor("knee"));
  const std::string said = refusal(text);
  EXPECT_NE(said.find("knee, shin (with a spring), tarsus, heel (with a spring)"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("a leaf or a compliant link, is no mechanism here"), std::string::npos);
}

TEST(OpenedLoops, LeaveABallElsewhereThreeHinges) {
  const std::string bar = foreign().front().ours;
  const Imported read = read_text(
      replaced(bar, "</body></worldbody>",
               "<body name=\"x\"><joint type=\"ball\"/>" + kFoot + "</body></body></worldbody>"));
  EXPECT_TRUE(std::any_of(read.notes.begin(), read.notes.end(), [](const std::string& note) {
    return note.find("ball joints are hinges about x, y and z") != std::string::npos;
  }));
}

INSTANTIATE_TEST_SUITE_P(Foreign, OpenedLoop, testing::ValuesIn(foreign()),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace torquewright::hopper
