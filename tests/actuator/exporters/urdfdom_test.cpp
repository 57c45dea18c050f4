// SPDX-License-Identifier: Apache-2.0
// Oracle: urdfdom, the parser that ROS and most simulators read URDF with.
#include <gtest/gtest.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"

namespace torquewright::actuator {
namespace {

TEST(Urdf, IsReadAsItWasMeant) {
  for (const LawFit fit : {LawFit::kConservative, LawFit::kBest}) {
    const Example example(knee());
    const SimulatorFile file =
        simulator_file(example.subject(fit), exporters::urdf, {"a note -- with -- hyphens"});
    const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(file.text);
    ASSERT_TRUE(model);
    const urdf::JointConstSharedPtr joint = model->getJoint("joint");
    ASSERT_TRUE(joint);
    ASSERT_TRUE(joint->limits);
    EXPECT_EQ(joint->type, urdf::Joint::CONTINUOUS);
    EXPECT_EQ(joint->limits->effort, file.shape[0]);
    EXPECT_EQ(joint->limits->velocity, file.shape[1]);
    EXPECT_EQ(joint->dynamics->friction, 0.0);
    EXPECT_EQ(joint->dynamics->damping, 0.0);
  }
}

// Whatever an actuator is called.
TEST(Urdf, IsReadUnderAnyName) {
  Actuator actuator = knee();
  actuator.name = "7 \"knees\" --> <x> & \\";
  const Example example(actuator);
  const SimulatorFile file =
      simulator_file(example.subject(LawFit::kBest), exporters::urdf, {"a --- b"});
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(file.text);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->getName(), actuator.name);
}

}  // namespace
}  // namespace torquewright::actuator
