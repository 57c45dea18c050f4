// SPDX-License-Identifier: Apache-2.0
// Robots as SDFormat. Oracle: libsdformat, the reader of Gazebo and of Drake: what it makes of a
// file against the robot's own kinematics (dynamics/tree_state.hpp) and document; limits and
// frictions of drives by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <sdf/sdf.hh>

#include "actuator/exporters/every_exporter.hpp"
#include "dynamics/tree_state.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/sdf/sdf_writer.hpp"
#include "robot/simulators/drives_in_joints.hpp"
#include "tests/robot/mjcf_friction_robot.hpp"

namespace torquewright::hopper {
namespace {

using actuator::FrictionPlace;

constexpr double kRounding = 1e-9;  // m, rad, kg m^2: angles of a pose there and back

Robot robot_in(const char* file) {
  return read_robot(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/robot" / file).robot;
}

/// The only model of a text that is read without a complaint.
class ReadSdf {
 public:
  explicit ReadSdf(const std::string& text) {
    for (const sdf::Error& error : root_.LoadSdfString(text)) {
      ADD_FAILURE() << error.Message();
    }
  }
  const sdf::Model& model() const { return *root_.Model(); }
  const sdf::JointAxis& axis(const std::string& joint) const {
    return *model().JointByName(joint)->Axis();
  }

 private:
  sdf::Root root_;
};

template <typename Vector>
Eigen::Vector3d vector_of(const Vector& vector) {
  return {vector.X(), vector.Y(), vector.Z()};
}

template <typename Quaternion>
Eigen::Matrix3d rotation_of(const Quaternion& q) {
  return Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).toRotationMatrix();
}

void expect_near(const Eigen::MatrixXd& one, const Eigen::MatrixXd& other,
                 const std::string& what) {
  EXPECT_LE((one - other).cwiseAbs().maxCoeff(), kRounding) << what << "\n"
                                                            << one << "\nfor\n"
                                                            << other;
}

/// Poses at position zero, and what links weigh.
void expect_links(const Robot& robot, const sdf::Model& model) {
  const dynamics::TreeStateOf<double> state(robot.tree);
  const Eigen::Vector3d base_m = robot.tree.base == dynamics::BaseKind::kFixed
                                     ? robot.tree.bodies.front().joint.p_PB_m
                                     : Eigen::Vector3d::Zero().eval();
  const bool is_world = robot.tree.bodies.front().name == "world";
  for (std::size_t i = is_world ? 1 : 0; i < robot.tree.bodies.size(); ++i) {
    const dynamics::Body& body = robot.tree.bodies[i];
    const sdf::Link* link = model.LinkByName(body.name);
    ASSERT_NE(link, nullptr) << body.name;
    ignition::math::Pose3d pose;
    ASSERT_TRUE(link->SemanticPose().Resolve(pose, "__model__").empty()) << body.name;
    expect_near(vector_of(pose.Pos()), state.motion(i).origin_m + base_m, body.name);
    expect_near(rotation_of(pose.Rot()), state.motion(i).R_WB, body.name);
    if (body.inertia.mass_kg == 0) continue;
    EXPECT_EQ(link->Inertial().MassMatrix().Mass(), body.inertia.mass_kg);
    expect_near(vector_of(link->Inertial().Pose().Pos()), body.inertia.center_of_mass_m, body.name);
    const auto moment = link->Inertial().Moi();
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        EXPECT_NEAR(moment(static_cast<std::size_t>(row), static_cast<std::size_t>(column)),
                    body.inertia.inertia_kg_m2(row, column), kRounding);
      }
    }
  }
}

void expect_joints(const Robot& robot, const ReadSdf& read) {
  const dynamics::TreeStateOf<double> state(robot.tree);
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = robot.tree.bodies[i].joint;
    const sdf::Joint* found = read.model().JointByName(joint.name);
    ASSERT_NE(found, nullptr) << joint.name;
    EXPECT_EQ(found->ChildLinkName(), robot.tree.bodies[i].name);
    ignition::math::Vector3d axis;
    ASSERT_TRUE(found->Axis()->ResolveXyz(axis, "__model__").empty());
    expect_near(vector_of(axis), state.motion(i).axis, joint.name);
    if (std::isfinite(joint.limits.position_min)) {
      EXPECT_EQ(found->Axis()->Lower(), joint.limits.position_min);
      EXPECT_EQ(found->Axis()->Upper(), joint.limits.position_max);
    } else {
      EXPECT_EQ(found->Type(), joint.kind == dynamics::JointKind::kRevolute
                                   ? sdf::JointType::CONTINUOUS
                                   : sdf::JointType::PRISMATIC);
    }
    EXPECT_EQ(found->Axis()->SpringStiffness(), joint.passive.stiffness);
    EXPECT_EQ(found->Axis()->SpringReference(), joint.passive.rest_position);
    EXPECT_EQ(found->Axis()->Damping(), joint.passive.damping);
  }
}

TEST(Sdf, IsReadAsTheRobotIs) {
  for (const char* file : {"hopper.json", "cassie.json", "mini_cheetah.json", "rabbit.json"}) {
    SCOPED_TRACE(file);
    Robot robot = robot_in(file);
    robot.tree.bodies.back().joint.passive = {0.25, 0.5, 0.5, 30.0, -0.1};
    for (const SdfReader reader : {SdfReader::kGazebo, SdfReader::kDrake}) {
      const ReadSdf read(sdf_of(robot, reader).text);
      expect_links(robot, read.model());
      expect_joints(robot, read);
    }
  }
}

TEST(Sdf, StandsWhereAFixedBaseDoes) {
  Robot robot = test::driven_hinge({}, {});  // on the world itself
  dynamics::Joint& base = robot.tree.bodies.front().joint;
  base.p_PB_m = {0.1, -0.2, 0.7};
  base.R_PB = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const ReadSdf on_world(sdf_of(robot, SdfReader::kGazebo).text);
  expect_links(robot, on_world.model());
  EXPECT_EQ(on_world.model().LinkCount(), 1U);
  EXPECT_EQ(on_world.model().JointByName("hinge")->ParentLinkName(), "world");
  robot.tree.bodies.front().name = "stand";
  const ReadSdf read(sdf_of(robot, SdfReader::kGazebo).text);
  expect_links(robot, read.model());
  const sdf::Joint* weld = read.model().JointByName("world_joint");
  ASSERT_NE(weld, nullptr);
  EXPECT_EQ(weld->ParentLinkName(), "world");
  EXPECT_EQ(weld->Type(), sdf::JointType::FIXED);
}

// Links and joints may share names in our documents and in URDF.
TEST(Sdf, RenamesLinksThatAreCalledAsJoints) {
  Robot robot = robot_in("mini_cheetah.json");
  robot.tree.bodies[1].name = robot.tree.bodies[1].joint.name;
  robot.tree.bodies[2].name = "__link__";
  const Exported exported = sdf_of(robot, SdfReader::kGazebo);
  const ReadSdf read(exported.text);
  EXPECT_EQ(read.model().LinkCount(), robot.tree.bodies.size());
  EXPECT_NE(read.model().JointByName(robot.tree.bodies[1].joint.name), nullptr);
  EXPECT_NE(read.model().LinkByName(robot.tree.bodies[1].joint.name + "_link"), nullptr);
  EXPECT_NE(exported.text.find("share their names"), std::string::npos);
}

// By hand: the knee's four-bar has ratio 1, its drive 320 Nm, held up to the speed where the
// region falls; what drive and joint drag stands there once; of Drake the drive's dry friction is
// in the limit.
TEST(Sdf, HasDrivesInItsJoints) {
  constexpr double kCoulomb_Nm = 0.3;
  constexpr double kViscous_Nm_s_rad = 0.06;
  Robot robot = test::hopper_with_friction(kCoulomb_Nm, kViscous_Nm_s_rad);
  robot.tree.bodies[*robot.find_joint("knee")].joint.passive = {0.25, 0.5, 0.75, 0.0, 0.0};
  DrivesInJoints drives;
  const Robot gazebo =
      with_drives_in_joints(robot, actuator::exporters::sdf, FrictionPlace::kJoint, drives);
  const ReadSdf read(sdf_of(gazebo, SdfReader::kGazebo, drives).text);
  const sdf::JointAxis& knee = read.axis("knee");
  EXPECT_NEAR(knee.Effort(), 320.0, 1e-4);
  const actuator::Actuator motor = actuator::without_friction(robot.drivetrains[0].actuators[0]);
  const actuator::Region region(motor, {});
  EXPECT_GE(region.at(knee.MaxVelocity()).greatest.torque_Nm, knee.Effort());
  EXPECT_LT(region.at(1.01 * knee.MaxVelocity()).greatest.torque_Nm, 320.0);
  EXPECT_NEAR(knee.Friction(), kCoulomb_Nm + 0.5, 1e-12);
  EXPECT_NEAR(knee.Damping(), kViscous_Nm_s_rad + 0.25, 1e-12);

  DrivesInJoints of_drake;
  const Robot drake =
      with_drives_in_joints(robot, actuator::exporters::drake_sdf, FrictionPlace::kJoint, of_drake);
  const ReadSdf in_drake(sdf_of(drake, SdfReader::kDrake, of_drake).text);
  EXPECT_EQ(in_drake.axis("knee").Friction(), 0.0);
  EXPECT_NEAR(in_drake.axis("knee").Damping(), 0.25, 1e-12);
  EXPECT_LT(in_drake.axis("knee").Effort(), 320.0 - 0.9 * kCoulomb_Nm);
  const auto element = in_drake.model().JointByName("knee")->Element();
  const double ratio = element->Get<double>("drake:gear_ratio");
  EXPECT_NEAR(ratio * ratio * element->Get<double>("drake:rotor_inertia"),
              drake.tree.bodies[*drake.find_joint("knee")].joint.reflected_inertia, 1e-12);
  const auto says = [](const Exported& exported, const std::string& piece) {
    return exported.text.find(piece) != std::string::npos;
  };
  EXPECT_TRUE(says(sdf_of(drake, SdfReader::kDrake, of_drake), "no dry friction"));
  EXPECT_TRUE(says(sdf_of(drake, SdfReader::kDrake, of_drake), "knee 0.5"));
  EXPECT_TRUE(says(sdf_of(gazebo, SdfReader::kGazebo, drives), "no field for the armature"));
  EXPECT_FALSE(says(sdf_of(gazebo, SdfReader::kGazebo, drives), "mechanisms and their actuators"));
  // What each actuator's law loses stands in the file, and is not printed for each.
  const Exported written = sdf_of(gazebo, SdfReader::kGazebo, drives);
  EXPECT_TRUE(says(written, "Worst torque error"));
  for (const std::string& note : written.notes) {
    EXPECT_EQ(note.find("Worst torque error"), std::string::npos);
  }
}

// What no drive moves is no actuator of Drake's, if any effort is known; Gazebo reads no limit.
TEST(Sdf, CallsJointsWithoutDrivesPassiveInDrakeAlone) {
  Robot cassie = robot_in("cassie.json");
  cassie.drivetrains.erase(cassie.drivetrains.begin() + 4);
  cassie.tree.bodies[*cassie.find_joint("toe_left")].joint.limits.effort_max =
      std::numeric_limits<double>::infinity();
  DrivesInJoints drives;
  const Robot driven =
      with_drives_in_joints(cassie, actuator::exporters::drake_sdf, FrictionPlace::kLimits, drives);
  const ReadSdf drake(sdf_of(driven, SdfReader::kDrake, drives).text);
  const ReadSdf gazebo(sdf_of(driven, SdfReader::kGazebo, drives).text);
  std::size_t passive = 0;
  for (std::size_t i = 1; i < driven.tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = driven.tree.bodies[i].joint;
    if (std::isfinite(joint.limits.effort_max)) continue;
    ++passive;
    EXPECT_EQ(drake.axis(joint.name).Effort(), 0.0) << joint.name;
    EXPECT_TRUE(std::isinf(gazebo.axis(joint.name).Effort())) << joint.name;
  }
  EXPECT_GT(passive, 0U);
  const Exported bare = sdf_of(robot_in("cassie.json"), SdfReader::kDrake);
  EXPECT_TRUE(std::isinf(ReadSdf(bare.text).axis("toe_left").Effort()));
  EXPECT_EQ(bare.text.find("lack theirs"), std::string::npos);
  EXPECT_NE(sdf_of(driven, SdfReader::kDrake, drives).text.find("lack theirs"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
