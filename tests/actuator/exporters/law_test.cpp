// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/library.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kRounding_Nm = 1e-12;

TEST(ExporterLibrary, HasEachTargetOnceByName) {
  const std::vector<std::string_view> names{
      "mujoco",     "mujoco-dcmotor", "isaac-lab",  "isaac-lab-bam", "isaac-lab-remotized",
      "mjlab",      "mjlab-dcmotor",  "unitree-xy", "physx",         "newton",
      "raisim2",    "raisim1",        "urdf",       "sdf",           "drake",
      "drake-sdf",  "jaxsim",         "pybullet",   "isaac-gym",     "genesis",
      "playground", "python",         "c",          "isaac-lab-2.3"};
  ASSERT_EQ(exporter_library().size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(exporter_library()[i]->name, names[i]);
    EXPECT_EQ(find_exporter(names[i]), exporter_library()[i]);
    EXPECT_FALSE(exporter_library()[i]->source.empty());
  }
  EXPECT_EQ(find_exporter("bullet"), nullptr);
}

// Oracle: mjlab's own test of the Unitree law (tests/test_unitree_actuator.py): X1 10, X2 20, Y1
// 100, Y2 120; demanded 200 Nm one way or the other.
TEST(UnitreeLaw, PassesMjlabsTest) {
  const Shape shape{10.0, 20.0, 100.0, 120.0};
  const auto upper = [&](double speed) {
    return exporters::unitree_xy.law(shape, speed).greatest_Nm;
  };
  const auto lower = [&](double speed) { return exporters::unitree_xy.law(shape, speed).least_Nm; };
  EXPECT_NEAR(upper(5.0), 100.0, kRounding_Nm);
  EXPECT_NEAR(upper(15.0), 50.0, kRounding_Nm);
  EXPECT_NEAR(lower(15.0), -60.0, kRounding_Nm);
  EXPECT_NEAR(upper(20.0), 0.0, kRounding_Nm);
  EXPECT_NEAR(lower(-15.0), -50.0, kRounding_Nm);
  EXPECT_NEAR(upper(-15.0), 60.0, kRounding_Nm);
  // At rest speed times effort is not positive: the braking limit, both ways.
  EXPECT_NEAR(upper(0.0), 120.0, kRounding_Nm);
  EXPECT_NEAR(lower(0.0), -120.0, kRounding_Nm);
}

// Oracle: the motor N7520-14.3 of unitree_actuators.py @ b4430e63 (X1 22.63, X2 35.52, Y1 71,
// Y2 83.3) and that file's rule in words: linear from the whole torque at X1 to none at X2, never
// below 0, of Y1 where speed and effort have one sign, else of Y2.
TEST(UnitreeLaw, IsThatOfItsOwnMotor) {
  const Shape shape{22.63, 35.52, 71.0, 83.3};
  const auto at = [&](double speed) { return exporters::unitree_xy.law(shape, speed); };
  const double middle_rad_s = (22.63 + 35.52) / 2.0;
  EXPECT_NEAR(at(22.0).greatest_Nm, 71.0, kRounding_Nm);
  EXPECT_NEAR(at(22.0).least_Nm, -83.3, kRounding_Nm);
  EXPECT_NEAR(at(middle_rad_s).greatest_Nm, 35.5, 1e-11);
  EXPECT_NEAR(at(-middle_rad_s).greatest_Nm, 41.65, 1e-11);
  EXPECT_NEAR(at(40.0).greatest_Nm, 0.0, kRounding_Nm);
  EXPECT_NEAR(at(40.0).least_Nm, 0.0, kRounding_Nm);
}

// Oracle: the numbers of RaiSim 2's documentation at the joint: gear 10, 15 Nm at rest, no-load
// speed 24 rad/s, 1 Nm left at 23.8 rad/s, overspeed 27 rad/s; past it the voltage limit alone.
TEST(Raisim2Law, IsTheDocumentedMotor) {
  const Shape shape{120.0, 24.0, 15.0};
  const auto at = [&](double speed) { return exporters::raisim2.law(shape, speed); };
  EXPECT_NEAR(at(0.0).greatest_Nm, 15.0, kRounding_Nm);
  EXPECT_NEAR(at(23.8).greatest_Nm, 1.0, 1e-11);
  EXPECT_NEAR(at(23.8).least_Nm, -15.0, kRounding_Nm);
  EXPECT_NEAR(at(30.0).greatest_Nm, -30.0, kRounding_Nm);
  EXPECT_NEAR(at(30.0).least_Nm, -30.0, kRounding_Nm);
  EXPECT_NEAR(at(-30.0).least_Nm, 30.0, kRounding_Nm);
}

// Oracle: the formulas printed in Isaac Lab's DCMotor and in Newton's ClampingDCMotor.
TEST(LineLaws, DifferPastTheOverspeedOnly) {
  const Shape shape{100.0, 10.0, 50.0};  // overspeed 15 rad/s
  for (const double speed : {-14.9, -10.0, -5.0, 0.0, 3.0, 7.0, 12.0, 14.9}) {
    const double upper_Nm = std::min(100.0 * (1.0 - speed / 10.0), 50.0);
    const double lower_Nm = std::max(100.0 * (-1.0 - speed / 10.0), -50.0);
    for (const Exporter* exporter :
         {&exporters::isaac_lab, &exporters::mjlab, &exporters::mujoco, &exporters::mujoco_dcmotor,
          &exporters::newton, &exporters::isaac_lab_bam, &exporters::mjlab_dcmotor}) {
      const TorqueLimits at = exporter->law(shape, speed);
      EXPECT_NEAR(at.greatest_Nm, upper_Nm, kRounding_Nm) << exporter->name << " " << speed;
      EXPECT_NEAR(at.least_Nm, lower_Nm, kRounding_Nm) << exporter->name << " " << speed;
    }
  }
  const TorqueLimits isaac = exporters::isaac_lab.law(shape, 17.0);
  EXPECT_EQ(isaac.greatest_Nm, -50.0);
  EXPECT_EQ(isaac.least_Nm, -50.0);
  const TorqueLimits newton = exporters::newton.law(shape, 17.0);
  EXPECT_NEAR(newton.greatest_Nm, -50.0, kRounding_Nm);  // of the corner velocity, 15 rad/s
  EXPECT_EQ(newton.least_Nm, -50.0);
}

// Oracle: PxPerformanceEnvelope's two inequalities: 0.1 rad/s less per Nm from 20 rad/s on.
TEST(PhysxLaw, IsBothInequalities) {
  const Shape shape{60.0, 20.0, 0.1};
  EXPECT_NEAR(exporters::physx.law(shape, 13.0).greatest_Nm, 60.0, kRounding_Nm);
  EXPECT_NEAR(exporters::physx.law(shape, 15.0).greatest_Nm, 50.0, kRounding_Nm);
  EXPECT_NEAR(exporters::physx.law(shape, -15.0).least_Nm, -50.0, kRounding_Nm);
  EXPECT_EQ(exporters::physx.law(shape, 21.0).greatest_Nm, 0.0);
}

// Oracle: JaxSim's tn_curve_fn with its default parameters 3000, 30, 100.
TEST(JaxsimLaw, IsPlateauAndDrop) {
  const Shape shape{3000.0, 30.0, 100.0};
  EXPECT_EQ(exporters::jaxsim.law(shape, 30.0).greatest_Nm, 3000.0);
  EXPECT_NEAR(exporters::jaxsim.law(shape, -65.0).greatest_Nm, 1500.0, 1e-9);
  EXPECT_NEAR(exporters::jaxsim.law(shape, 65.0).least_Nm, -1500.0, 1e-9);
  EXPECT_EQ(exporters::jaxsim.law(shape, 101.0).greatest_Nm, 0.0);
}

TEST(UrdfLaw, IsABoxThatSaysNothingBeyondItsSpeed) {
  const Shape shape{320.0, 10.0};
  EXPECT_EQ(exporters::urdf.law(shape, 10.0).greatest_Nm, 320.0);
  EXPECT_EQ(exporters::urdf.law(shape, -10.0).least_Nm, -320.0);
  EXPECT_TRUE(std::isinf(exporters::urdf.law(shape, 10.1).greatest_Nm));
}

}  // namespace
}  // namespace torquewright::actuator
