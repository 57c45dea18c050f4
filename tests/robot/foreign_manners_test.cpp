// SPDX-License-Identifier: Apache-2.0
// Manners of public robot files that were refused or read another way than simulators do. Oracles:
// the same robot written plainly, by its dynamics; the words themselves.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/urdf/urdf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/imported_notes.hpp"
#include "tests/robot/same_robot.hpp"

namespace torquewright::hopper {
namespace {

using test::all_of;
using test::refusal;

// Some tens of roundings, as a share of the largest element.
constexpr double kSameRobot = 1e-12;

Imported mjcf(const std::string& text) {
  const test::ScratchFolder folder;
  return read_mjcf(folder.write("robot.xml", text));
}

/// A trunk on these joints, a leg on it.
std::string floating(const std::string& joints, const std::string& sections = "") {
  return R"(<mujoco><worldbody><body name="trunk" pos="0 0 1" euler="5 10 15">)" + joints +
         R"(<inertial pos="0.1 0 0.02" mass="5" diaginertia="0.05 0.06 0.07"/>
    <body name="leg" pos="0.1 0.1 -0.2"><joint name="hip" axis="0 1 0" range="-45 45"/>
      <inertial pos="0 0 -0.1" mass="1" diaginertia="0.01 0.01 0.01"/></body></body></worldbody>)" +
         sections + "</mujoco>";
}

const char* const kSlides = R"(<joint name="x" type="slide" axis="1 0 0"/>
  <joint name="y" type="slide" axis="0 1 0"/><joint name="z" type="slide" axis="0 0 1"/>)";

// Converted human models and some walkers have no free joint: what moves as one is one.
TEST(ForeignManners, SlidesAndHingesOfABaseAreAFreeJoint) {
  const Robot plain = mjcf(floating("<freejoint/>")).robot;
  for (
      const char* turning :
      {R"(<joint name="rx" axis="1 0 0"/><joint name="ry" axis="0 1 0"/><joint name="rz" axis="0 0 1"/>)",
       R"(<joint name="ball" type="ball"/>)"}) {
    const Imported read = mjcf(floating(std::string(kSlides) + turning));
    EXPECT_EQ(read.robot.tree.base, dynamics::BaseKind::kSpatial);
    EXPECT_LT(test::dynamic_difference(read.robot, plain), kSameRobot);
    const std::string notes = all_of(read.notes);
    EXPECT_NE(notes.find("are one free joint here"), std::string::npos) << notes;
    EXPECT_EQ(notes.find("ball joints are hinges"), std::string::npos) << notes;
  }
}

// A hand on an arm of slides and hinges floats nowhere; nor does what leaves a direction out.
TEST(ForeignManners, DrivenOrFewerJointsOfABaseStayJoints) {
  const std::string hinges =
      R"(<joint name="rx" axis="1 0 0"/><joint name="ry" axis="0 1 0"/><joint name="rz" axis="0 0 1"/>)";
  const std::string driven = R"(<actuator><motor joint="z"/></actuator>)";
  const std::string twice =
      R"(<joint name="x" type="slide" axis="1 0 0"/><joint name="y" type="slide" axis="0 1 0"/>
         <joint name="z" type="slide" axis="1 1 0"/>)";
  for (const std::string& text :
       {floating(kSlides + hinges, driven), floating(kSlides), floating(twice + hinges)}) {
    EXPECT_EQ(mjcf(text).robot.tree.base, dynamics::BaseKind::kFixed);
  }
}

// MuJoCo's own default of a range, written out in a class: none.
TEST(ForeignManners, ARangeOfZerosIsNoneUnlessItIsSaidToHold) {
  const auto with = [](const std::string& range) {
    return floating(R"(<freejoint/><body name="wheel"><joint name="wheel" axis="0 1 0" )" + range +
                    R"(/><inertial pos="0 0 0" mass="1" diaginertia="0.01 0.01 0.01"/></body>)");
  };
  const Robot robot = mjcf(with(R"(range="0 0")")).robot;
  EXPECT_TRUE(std::isinf(robot.tree.bodies[1].joint.limits.position_max));
  EXPECT_NE(refusal([&] {
              return mjcf(with(R"(range="0 0" limited="true")"));
            }).find("the range's first number is not below its second"),
            std::string::npos);
}

// A robot in a harness: what holds it to the world is left out where that is asked for.
TEST(ForeignManners, AConnectToTheWorldCanBeOpened) {
  const std::string text =
      floating("<freejoint/>",
               R"(<equality><connect name="harness" body1="trunk" anchor="0 0 0.1"/></equality>)");
  EXPECT_NE(refusal([&] { return mjcf(text); }).find("(--open-loop NAME leaves it out)"),
            std::string::npos);
  const test::ScratchFolder folder;
  ImportFileOptions opens;
  opens.opened_loops = {"harness"};
  const Imported read = read_mjcf(folder.write("robot.xml", text), opens);
  EXPECT_EQ(read.robot.tree.bodies.size(), 2U);
  EXPECT_NE(all_of(read.notes).find("is opened (--open-loop)"), std::string::npos);
  // So with a trunk that is welded to the world, as scenes hang robots up.
  opens.opened_loops = {"trunk"};
  const Imported hung = read_mjcf(
      folder.write("hung.xml",
                   floating("<freejoint/>", R"(<equality><weld body1="trunk"/></equality>)")),
      opens);
  EXPECT_EQ(hung.robot.tree.base, dynamics::BaseKind::kSpatial);
  EXPECT_NE(all_of(hung.notes).find("<weld> is left out (--open-loop)"), std::string::npos);
}

const std::string kLink =
    R"(<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>)";

// A robot of ROS names its meshes by packages; the file stands in the folder where one works.
TEST(ForeignManners, AFileNamedAloneFindsMeshesOfPackages) {
  const test::ScratchFolder folder;
  folder.write("robot.urdf",
               "<robot name='r'><link name='foot'>" + kLink +
                   "<collision><geometry><mesh filename='package://r/meshes/foot.stl'/>"
                   "</geometry></collision></link></robot>");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const std::string said = refusal([] { return read_urdf("robot.urdf"); });
  std::filesystem::current_path(before);
  EXPECT_EQ(said, "was read");
}

// Joints for which the format demands a limit and that have none: free, and said.
TEST(ForeignManners, JointsWithoutALimitAreFreeAndSaid) {
  const std::string text = "<robot name='r'><link name='a'>" + kLink + "</link><link name='b'>" +
                           kLink +
                           "</link><joint name='bare' type='revolute'><parent link='a'/><child "
                           "link='b'/><axis xyz='0 0 1'/></joint></robot>";
  const test::ScratchFolder folder;
  const auto file = folder.write("robot.urdf", text);
  const Imported read = read_urdf(file);
  ASSERT_EQ(read.robot.tree.bodies.size(), 2U);
  EXPECT_NE(all_of(read.notes).find("(--weld-locked holds them at zero): bare"), std::string::npos)
      << all_of(read.notes);
  ImportFileOptions welds;
  welds.welds_locked = true;
  EXPECT_EQ(read_urdf(file, welds).robot.tree.bodies.size(), 1U);
}

TEST(ForeignManners, OfAnotherFormatAreToldWhichItIs) {
  const test::ScratchFolder folder;
  const auto urdf = folder.write("model.xml", "<robot name='r'/>");
  const auto mujoco = folder.write("model.urdf", "<mujoco/>");
  EXPECT_NE(refusal([&] { return read_mjcf(urdf); }).find("URDF, which --format urdf reads"),
            std::string::npos);
  EXPECT_NE(refusal([&] { return read_urdf(mujoco); }).find("MJCF, which --format mjcf reads"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
