// SPDX-License-Identifier: Apache-2.0
// What MJCF says of mass and kinematics by other words than ours. Oracle: MuJoCo 2.2.2 on the same
// text; where that is too old for a word, on the text that its documentation says is the same.
#include <gtest/gtest.h>

#include <algorithm>

#include "robot/mjcf/mjcf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/mujoco_twin.hpp"

namespace torquewright::hopper {
namespace {

// Hundreds of roundings of rotations that a file states with as many digits as doubles have.
constexpr double kSame = 1e-12;

struct Case {
  const char* name;
  std::string ours;
  std::string theirs = {};  ///< Empty: the same.
  ImportFileOptions options = {};
};

std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }

/// A trunk that the world carries, and an arm on it whose parts are filled in.
std::string arm(const std::string& head, const std::string& trunk, const std::string& fore) {
  return "<mujoco>" + head +
         R"(<worldbody><body name="trunk" pos="0.1 0.2 0.3" quat="0.8 0.6 0 0">
      <inertial pos="0.01 0.02 0.03" mass="3" diaginertia="0.05 0.04 0.03"/>)" +
         trunk + R"(<body name="fore" pos="0.3 0.1 -0.2" quat="0.6 0 0.8 0">)" + fore +
         "</body></body></worldbody></mujoco>";
}

const char* const kHinge = R"(<joint name="a" axis="0.6 0 0.8" pos="0.1 0.05 -0.02"/>)";
const char* const kPart =
    R"(<inertial pos="0.05 0 0.1" mass="1.5" quat="0.6 0.8 0 0" diaginertia="0.02 0.03 0.015"/>)";

std::string planar(const std::string& top, const std::string& joints) {
  return "<mujoco><worldbody><body name=\"trunk\" " + top + ">" + joints + kPart +
         R"(<body name="leg" pos="0.1 0 -0.2"><joint name="k" axis="0 1 0"/>)" + kPart +
         "</body></body></worldbody></mujoco>";
}

const char* const kSlides = R"(<joint name="x" type="slide" axis="1 0 0"/>
    <joint name="z" type="slide" axis="0 0 1" ref="1.25"/>)";

std::string shape(const std::string& geom, const std::string& head = "") {
  return arm(head, kHinge, R"(<joint name="b" axis="0 1 0"/>)" + geom);
}

std::vector<Case> cases() {
  const std::string fore = std::string(R"(<joint name="b" axis="1 0 0"/>)") + kPart;
  const std::string posed = R"(<body name="tip" pos="0.1 0 0.2" %><joint name="c" axis="0 1 0"/>)" +
                            std::string(kPart) + "</body>";
  const auto turned = [&](const std::string& how) {
    std::string text = posed;
    return text.replace(text.find('%'), 1, how);
  };
  const std::string other = R"(<worldbody><body name="ball"><geom size="0.1"/></body></worldbody>)";
  const std::string two_worlds =
      "<mujoco><worldbody><geom type=\"plane\" size=\"1 1 1\"/></worldbody><worldbody>"
      "<body name=\"fore\" pos=\"1 2 3\">" +
      fore + "</body></worldbody></mujoco>";
  return {
      {"RefOfAHinge",
       arm("", kHinge,
           R"(<joint name="b" axis="0 0.6 0.8" pos="0.1 0 0" ref="40"/>)" + std::string(kPart))},
      {"RefOfASlide",
       arm("", kHinge,
           R"(<joint name="b" type="slide" axis="0 0.6 0.8" ref="0.4"/>)" + std::string(kPart))},
      {"PassiveForcesOfAHinge",
       arm("", kHinge,
           R"(<joint name="b" axis="0 0.6 0.8" ref="40" stiffness="30" springref="15" damping="0.7" frictionloss="1.3"/>)" +
               std::string(kPart))},
      {"PassiveForcesOfASlideInRadians",
       arm("<compiler angle=\"radian\"/>", kHinge,
           R"(<joint name="b" type="slide" axis="0 1 0" stiffness="300" springref="-0.1" damping="7"/>)" +
               std::string(kPart))},
      {"SeveralJointsInABody", arm("", kHinge,
                                   R"(<joint name="b" axis="0 0 1" ref="20" pos="0.1 0 0"/>
          <joint name="c" type="slide" axis="1 0 0" ref="-0.3"/><joint name="d" axis="0 0.6 0.8" pos="0 0.2 0"/>)" +
                                       std::string(kPart))},
      {"RangeOfZeros",
       arm("", kHinge, R"(<joint name="b" axis="0 0 1" range="0 0"/>)" + std::string(kPart))},
      {"SecondWorldbody", two_worlds},
      {"SetTotalMass", arm("<compiler settotalmass=\"30\"/>" + other, kHinge, fore), "", {"trunk"}},
      {"InertiaFromGeom", arm("<compiler inertiafromgeom=\"true\"/>",
                              std::string(kHinge) + "<geom size=\"0.1\" pos=\"0.2 0 0\"/>", fore)},
      {"BalanceInertia",
       arm("<compiler balanceinertia=\"true\"/>", kHinge,
           R"(<joint name="b" axis="1 0 0"/><inertial pos="0 0 0.1" mass="1" quat="0.6 0.8 0 0" diaginertia="0.01 0.02 0.09"/>)")},
      {"BoundMass", arm("<compiler boundmass=\"2\" boundinertia=\"0.025\"/>", kHinge, fore)},
      {"PlanarBaseTurned",
       planar(
           "pos=\"0.5 0.3 1.25\" euler=\"0 25 0\"",
           R"(<joint name="x" type="slide" axis="0.906307787036649937 0 0.422618261740699436"/><joint name="z" type="slide" axis="-0.422618261740699436 0 0.906307787036649937"/><joint name="p" axis="0 1 0"/>)")},
      {"PlanarBaseTurnedOver",
       planar(
           "pos=\"0 0 1\" quat=\"0 0 0 1\"",
           R"(<joint name="x" type="slide" axis="-1 0 0"/><joint name="z" type="slide" axis="0 0 1"/><joint name="p" axis="0 -1 0"/>)")},
      {"PlanarBaseWithPlaceOfItsHinge",
       planar("pos=\"0 0 1.25\"",
              std::string(kSlides) +
                  R"(<joint name="p" axis="0 1 0" pos="0.1 0.05 -0.3" ref="10"/>)")},
      {"PlanarBaseOtherOrder",
       planar(
           "pos=\"0 0 1\"",
           R"(<joint name="z" type="slide" axis="0 0 1"/><joint name="x" type="slide" axis="1 0 0"/><joint name="p" axis="0 1 0"/>)")},
      {"PlanarBaseWithArmature",
       planar("pos=\"0 0 1\"",
              std::string(kSlides) + R"(<joint name="p" axis="0 1 0" armature="0.2"/>)")},
      {"OtherPlane",
       planar(
           "pos=\"0 0 1\"",
           R"(<joint name="x" type="slide" axis="1 0 0"/><joint name="y" type="slide" axis="0 1 0"/><joint name="p" axis="0 0 1"/>)")},
      {"FreeJointOfAType",
       planar("pos=\"0 0 1\" euler=\"10 20 30\"", R"(<joint name="f" type="free"/>)")},
      {"NoGravity", arm("<option><flag gravity=\"disable\"/></option>", kHinge, fore)},
      {"NoPassiveForces",
       arm("<option><flag passive=\"disable\"/></option>", kHinge,
           R"(<joint name="b" axis="0 0.6 0.8" stiffness="30" springref="15" damping="0.7"/>)" +
               std::string(kPart)),
       arm("", kHinge, R"(<joint name="b" axis="0 0.6 0.8"/>)" + std::string(kPart))},
      {"NoSprings",
       arm("<option><flag spring=\"disable\"/></option>", kHinge,
           R"(<joint name="b" axis="0 0.6 0.8" stiffness="30" springref="15" damping="0.7"/>)" +
               std::string(kPart)),
       arm("", kHinge, R"(<joint name="b" axis="0 0.6 0.8" damping="0.7"/>)" + std::string(kPart))},
      {"NoEqualities",
       arm("<option><flag equality=\"disable\"/></option><equality><joint joint1=\"a\" "
           "joint2=\"b\"/></equality>",
           kHinge, fore)},
      {"EulerOfAnotherOrder",
       arm("<compiler eulerseq=\"zyx\"/>", kHinge, fore + turned("euler=\"10 20 30\""))},
      {"EulerAboutFixedAxes", arm("<compiler eulerseq=\"XZY\" angle=\"radian\"/>", kHinge,
                                  fore + turned("euler=\"0.1 0.2 0.3\""))},
      {"XyAxes", arm("", kHinge, fore + turned("xyaxes=\"1 0.2 0 0.3 1 0.5\""))},
      {"ZAxis", arm("", kHinge, fore + turned("zaxis=\"1 0.2 -0.3\""))},
      {"AxisAngle", arm("", kHinge, fore + turned("axisangle=\"1 0.2 -0.3 50\""))},
      {"DefaultsOfShapesAndNestedClasses",
       arm(R"(<default><geom density="500" type="capsule" size="0.05 0.2"/><joint armature="0.01" axis="0 1 0"/>
          <default class="leg"><joint armature="0.3"/><geom density="2000"/><default class="foot"><geom type="box" size="0.1 0.05 0.02"/></default></default></default>)",
           kHinge,
           R"(<joint name="b" class="leg"/><geom/><body name="l" childclass="leg" pos="0 0 1"><joint name="c"/><geom/><body name="f" pos="0 0 1" childclass="foot"><joint name="d"/><geom/><geom class="main" pos="0 0 0.1"/></body></body>)")},
      {"ASphere", shape(R"(<geom size="0.1" pos="0.1 0.2 0.3"/>)")},
      {"ACapsule",
       shape(R"(<geom type="capsule" size="0.05 0.2" euler="10 20 30" density="700"/>)")},
      {"ACylinder", shape(R"(<geom type="cylinder" size="0.05 0.2" zaxis="1 1 0" mass="2"/>)")},
      {"ABox",
       shape(R"(<geom type="box" size="0.05 0.2 0.1" xyaxes="0 1 0 0 0 1" pos="0 0 0.1"/>)")},
      {"AnEllipsoid", shape(R"(<geom type="ellipsoid" size="0.05 0.2 0.1" quat="0.6 0.8 0 0"/>)")},
      {"ACapsuleFromTo",
       shape(R"(<geom type="capsule" size="0.05" fromto="0.1 0.2 0.3 0.4 -0.1 0.2"/>)")},
      {"ACylinderFromTo",
       shape(R"(<geom type="cylinder" size="0.05" fromto="0 0 0.3 0 0 -0.2"/>)")},
      {"ABoxFromTo",
       shape(R"(<geom type="box" size="0.05 0.02" fromto="0.1 0.2 0.3 0.4 -0.1 0.2"/>)")},
      {"AnEllipsoidFromTo",
       shape(R"(<geom type="ellipsoid" size="0.05 0.02" fromto="0.1 0.2 0.3 0.4 -0.1 0.2"/>)")},
      {"GroupsOfShapes", shape(R"(<geom size="0.1"/><geom group="3" size="0.2"/>)",
                               "<compiler inertiagrouprange=\"3 4\"/>")},
      {"AShapeWithoutMass",
       shape(
           R"(<geom size="0.1"/><geom mass="0" size="0.2"/><geom density="0" size="0.3" pos="1 1 1"/>)")},
      {"Frames",
       arm("", kHinge,
           fore +
               R"(<frame pos="0.1 0.2 0.3" euler="0 0 90"><frame pos="0 0 0.5"><body name="tip" pos="0.1 0 0"><joint name="c" axis="0 1 0"/><geom size="0.1" pos="0 0 0.2"/></body></frame></frame>)"),
       arm("", kHinge,
           fore +
               R"(<body name="tip" pos="0.1 0.3 0.8" euler="0 0 90"><joint name="c" axis="0 1 0"/><geom size="0.1" pos="0 0 0.2"/></body>)")},
      {"JointsAndShapesInFrames",
       arm("", kHinge,
           R"(<frame pos="0.1 0.2 0.3" euler="0 0 90"><joint name="b" axis="1 0 0" pos="0.1 0 0"/><geom type="box" size="0.1 0.2 0.3" pos="0.1 0 0"/></frame>)"),
       arm("", kHinge,
           R"(<joint name="b" axis="0 1 0" pos="0.1 0.3 0.3"/><geom type="box" size="0.1 0.2 0.3" pos="0.1 0.3 0.3" euler="0 0 90"/>)")},
      {"FramesAroundTheTop",
       "<mujoco><worldbody><frame pos=\"0 0 1\" euler=\"0 30 0\"><body name=\"trunk\" pos=\"0.5 0 "
       "0\">" +
           fore + "</body></frame></worldbody></mujoco>",
       "<mujoco><worldbody><body name=\"trunk\" pos=\"0.433012701892219298 0 0.75\" euler=\"0 30 "
       "0\">" +
           fore + "</body></worldbody></mujoco>"},
  };
}

class Mjcf : public testing::TestWithParam<Case> {};

TEST_P(Mjcf, IsReadAsMujocoReadsIt) {
  const Case& one = GetParam();
  const test::ScratchFolder folder;
  const Imported read = read_mjcf(folder.write("robot.xml", one.ours), one.options);
  test::MujocoEngine mujoco(one.theirs.empty() ? one.ours : one.theirs);
  std::string top = one.options.body;
  if (top.empty()) top = mj_id2name(&mujoco.model(), mjOBJ_BODY, 1);
  const test::TwinDifference far = test::compare_with_mujoco(read.robot, mujoco, top);
  EXPECT_EQ(far.trouble, "");
  EXPECT_LE(far.mass, kSame);
  EXPECT_LE(far.place_m, kSame);
  EXPECT_LE(far.inertia, kSame);
  EXPECT_LE(far.matrix, kSame);
  EXPECT_LE(far.bias, kSame);
  EXPECT_LE(far.passive, kSame);
}

// Dry friction is a constraint there: no force at a state tells of it. Oracle: the words of its
// reference.
TEST(MjcfFlags, DisableDryFriction) {
  const std::string joint = R"(<joint name="b" axis="1 0 0" frictionloss="0.4"/>)";
  for (const std::string flag : {"frictionloss", "constraint"}) {
    const std::string file =
        arm("<option><flag " + flag + "=\"disable\"/></option>", kHinge, joint + kPart);
    const test::ScratchFolder folder;
    const Imported read = read_mjcf(folder.write("robot.xml", file), {});
    EXPECT_EQ(read.robot.tree.bodies.back().joint.passive.dry_friction, 0.0);
    const bool is_said = std::any_of(read.notes.begin(), read.notes.end(), [](const auto& note) {
      return note.find("which are left out of: b") != std::string::npos;
    });
    EXPECT_TRUE(is_said) << flag;
    const auto keeps_ranges = std::count(read.notes.begin(), read.notes.end(),
                                         "<flag> disables constraints; ranges of joints are kept");
    EXPECT_EQ(keeps_ranges, flag == "constraint" ? 1 : 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Words, Mjcf, testing::ValuesIn(cases()),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace torquewright::hopper
