// SPDX-License-Identifier: Apache-2.0
// Keyframes of a file as postures of the robot. Oracle: MuJoCo 2.2.2 on the same file: where each
// body stands in the keyframe, by its own kinematics, against the posture's in our tree, over the
// keyframe's own base.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <memory>

#include "dynamics/tree_state.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/imported_notes.hpp"

namespace torquewright::hopper {
namespace {

// Some tens of roundings of rotations.
constexpr double kSamePlace = 1e-12;

/// A ball that is no robot stands in front of one with a free base, a hinge that counts from
/// elsewhere, a slide by its class, hinges in a frame and behind it, and a ball joint.
const char* const kFile = R"(<mujoco><compiler angle="degree"/>
  <default><default class="rail"><joint type="slide" axis="0 0 1" limited="true" range="-1 1"/></default></default>
  <worldbody>
    <body name="prop"><freejoint/><geom size="0.1"/></body>
    <body name="trunk" pos="0 0 1"><freejoint/>
      <inertial pos="0 0 0" mass="3" diaginertia="0.03 0.03 0.03"/>
      <body name="thigh" pos="0.1 0 -0.2" euler="0 20 0">
        <joint name="hip" axis="0 1 0" ref="30" limited="true" range="-90 90"/>
        <inertial pos="0 0 -0.1" mass="1" diaginertia="0.01 0.01 0.01"/>
        <body name="shin" pos="0 0 -0.3" childclass="rail"><joint name="rail"/>
          <inertial pos="0 0 -0.1" mass="1" diaginertia="0.01 0.01 0.01"/>
        </body>
      </body>
      <body name="arm" pos="0 0.2 0.1"><joint name="shoulder" type="ball"/>
        <inertial pos="0 0 0.1" mass="1" diaginertia="0.01 0.01 0.01"/>
        <body name="hand" pos="0 0 0.3"><joint name="wrist" axis="1 0 0"/>
          <inertial pos="0 0 0.1" mass="0.5" diaginertia="0.01 0.01 0.01"/>
        </body>
      </body>
    </body>
  </worldbody>
  <keyframe>
    <key name="home" qpos="5 5 5 1 0 0 0  0 0 0.9 1 0 0 0  0.4 -0.25  0.9 0.1 0.3 -0.2  0.7"/>
    <key qpos="5 5 5 1 0 0 0  0.3 0.2 0.9 0.8 0 0.6 0  -0.4 0.5  0.5 -0.5 0.1 0.7  -1.7"/>
    <key name="bent" qpos="0 0 0 1 0 0 0  0 0 0 1 0 0 0  1.6 0  1 0 0 0  0"/>
    <key name="later" time="3"/>
  </keyframe>
</mujoco>)";

using Model = std::unique_ptr<mjModel, void (*)(mjModel*)>;
using Data = std::unique_ptr<mjData, void (*)(mjData*)>;

/// In the trunk's frame, as MuJoCo has it.
Eigen::Isometry3d place_in_trunk(const mjModel* model, const mjData* data, const char* body) {
  const auto place = [&](const char* name) {
    const int id = mj_name2id(model, mjOBJ_BODY, name);
    const mjtNum* q = data->xquat + 4 * id;
    const mjtNum* p = data->xpos + 3 * id;
    return Eigen::Translation3d(p[0], p[1], p[2]) * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  };
  return Eigen::Isometry3d(place("trunk")).inverse() * Eigen::Isometry3d(place(body));
}

TEST(MjcfKeyframes, StandAsMujocoHasThem) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("robot.xml", kFile).string();
  const Imported read = read_mjcf(file, {.body = "trunk"});
  const std::string notes = test::all_of(read.notes);
  ASSERT_EQ(read.robot.postures.size(), 2U) << notes;
  EXPECT_NE(notes.find("postures are those of keyframes, with the base upright: home, key_1"),
            std::string::npos);
  EXPECT_NE(notes.find("the keyframe bent is left out: hip stands at 1.6 there"),
            std::string::npos);
  char error[200] = "";
  const Model model(mj_loadXML(file.c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(model) << error;
  const Data data(mj_makeData(model.get()), mj_deleteData);
  const dynamics::Tree& tree = read.robot.tree;
  dynamics::TreeState state(tree);
  for (int key = 0; key < 2; ++key) {
    const Posture& posture = read.robot.postures[static_cast<std::size_t>(key)];
    mj_resetDataKeyframe(model.get(), data.get(), key);
    mj_kinematics(model.get(), data.get());
    state.set(position_of(tree, posture), Eigen::VectorXd::Zero(tree.velocity_size()));
    for (const char* body : {"thigh", "shin", "arm", "hand"}) {
      // Hinge and slide are at their bodies' origins: ours are the file's frames there.
      const auto index = static_cast<std::size_t>(
          std::find_if(tree.bodies.begin(), tree.bodies.end(),
                       [&](const dynamics::Body& one) { return one.name == body; }) -
          tree.bodies.begin());
      ASSERT_LT(index, tree.bodies.size());
      const Eigen::Isometry3d theirs = place_in_trunk(model.get(), data.get(), body);
      const dynamics::BodyMotion& ours = state.motion(index);  // the base is upright
      EXPECT_LT((ours.R_WB - theirs.rotation()).cwiseAbs().maxCoeff(), kSamePlace)
          << posture.name << " " << body;
      EXPECT_LT((ours.origin_m - theirs.translation()).norm(), kSamePlace)
          << posture.name << " " << body;
    }
  }
}

// MuJoCo refuses such a file; the robot itself is not wrong for it.
TEST(MjcfKeyframes, OfAnotherLengthAreLeftOutAndSaid) {
  const test::ScratchFolder folder;
  const std::string file =
      folder
          .write("robot.xml", R"(<mujoco><worldbody><body name="a"><joint name="j" axis="0 1 0"/>
        <geom size="0.1"/></body></worldbody>
        <keyframe><key name="two" qpos="0 0"/><key name="none" qpos="x"/></keyframe></mujoco>)")
          .string();
  const Imported read = read_mjcf(file);
  EXPECT_TRUE(read.robot.postures.empty());
  const std::string notes = test::all_of(read.notes);
  EXPECT_NE(notes.find("the keyframe two is left out: its qpos is not the 1 numbers"),
            std::string::npos)
      << notes;
  EXPECT_NE(notes.find("the keyframe none is left out"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
