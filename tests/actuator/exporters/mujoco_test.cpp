// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo itself, the version of the system's package, which reads our files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/mor/clip_table.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/actuator/exporters/mujoco_simulation.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kOfPeak = 1e-6;  // the gains are printed so that they read back the same
constexpr int kSpeeds = 1000;

std::string exported(const Example& example, LawFit fit) {
  const Subject subject = example.subject(fit);
  const Shape shape = exporters::mujoco.shape(subject);
  return exporters::mujoco.write(subject, shape, {"a note -- with -- hyphens"});
}

TEST(Mujoco, ReadsTheFileAsItWasMeant) {
  const Example example(knee());
  const Simulation simulation(exported(example, LawFit::kConservative));
  ASSERT_EQ(simulation.model->nu, 1);
  ASSERT_EQ(simulation.model->nv, 1);
  EXPECT_NEAR(simulation.model->dof_armature[0], 400.0 * 0.000922, 1e-12);
  EXPECT_EQ(simulation.model->dof_damping[0], 0.0);
  EXPECT_EQ(simulation.model->dof_frictionloss[0], 0.0);
  EXPECT_NEAR(simulation.model->actuator_ctrlrange[1], 67.2, 1e-12);
  EXPECT_NEAR(simulation.model->actuator_forcerange[0], -320.0, 1e-9);
}

TEST(Mujoco, DeliversTheRegionInAllFourQuadrants) {
  const Example example(knee());
  Simulation simulation(exported(example, LawFit::kConservative));
  const double end_rad_s = example.region.greatest_speed_rad_s();
  double worst_Nm = 0.0;
  for (int i = -kSpeeds; i <= kSpeeds; ++i) {
    const double speed_rad_s = end_rad_s * i / kSpeeds;
    const JointRange range = example.region.at(speed_rad_s);
    ASSERT_FALSE(range.is_empty) << speed_rad_s;
    worst_Nm = std::max(
        {worst_Nm, std::abs(simulation.force_Nm(speed_rad_s, 67.2) - range.greatest.torque_Nm),
         std::abs(simulation.force_Nm(speed_rad_s, -67.2) - range.least.torque_Nm)});
  }
  std::printf("MuJoCo %s: worst deviation %.3g Nm, %.3g of the peak torque\n", mj_versionString(),
              worst_Nm, worst_Nm / 320.0);
  EXPECT_LE(worst_Nm, kOfPeak * 320.0);
}

// MuJoCo reads URDF as well.
TEST(Mujoco, ReadsOurUrdf) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kBest);
  std::string text = exporters::urdf.write(subject, exporters::urdf.shape(subject), {"note"});
  // It wants mass on whatever moves, which a limit's file does not know.
  const std::string link = "<link name=\"link\"/>";
  text.replace(text.find(link), link.size(),
               "<link name=\"link\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" "
               "izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>");
  const Simulation simulation(text);
  EXPECT_EQ(simulation.model->nv, 1);
  EXPECT_EQ(simulation.model->dof_damping[0], 0.0);
  EXPECT_EQ(simulation.model->dof_frictionloss[0], 0.0);
}

// More voltage than there is, is not to be had.
TEST(Mujoco, ClampsTheVoltage) {
  Simulation simulation(exported(Example(knee()), LawFit::kConservative));
  EXPECT_EQ(simulation.force_Nm(9.0, 1000.0), simulation.force_Nm(9.0, 67.2));
  EXPECT_NEAR(simulation.force_Nm(0.0, 7.0), 160.0, 1e-9);  // 1536 Nm per 67.2 V
}

TEST(Mujoco, DoesWhatTheLawSaysWhereTheRegionIsNone) {
  const Example example(lossy_knee());
  for (const LawFit fit : {LawFit::kConservative, LawFit::kBest}) {
    const Shape shape = exporters::mujoco.shape(example.subject(fit));
    Simulation simulation(exported(example, fit));
    const double end_rad_s = 1.2 * example.region.greatest_speed_rad_s();
    for (int i = -kSpeeds; i <= kSpeeds; ++i) {
      const double speed_rad_s = end_rad_s * i / kSpeeds;
      const TorqueLimits at = exporters::mujoco.law(shape, speed_rad_s);
      const double tolerance_Nm = kOfPeak * example.table.peak_torque_Nm;
      EXPECT_NEAR(simulation.force_Nm(speed_rad_s, 67.2), at.greatest_Nm, tolerance_Nm);
      EXPECT_NEAR(simulation.force_Nm(speed_rad_s, -67.2), at.least_Nm, tolerance_Nm);
    }
  }
}

constexpr const char* kBareJoint = R"(<mujoco><worldbody><body>
    <joint name="joint" type="hinge" axis="0 0 1"/><geom size="0.05" mass="1"/>
  </body></worldbody><actuator><motor joint="joint"/></actuator></mujoco>)";

/// What MuJoCo's callback, which is one for the whole process, clips with and to.
struct Callback {
  const Region* region = nullptr;  ///< Asked at every call; else the table.
  TableView table;
  double wanted_Nm = 0.0;
};
Callback callback;

void clip_control(const mjModel* /*model*/, mjData* data) {
  const double speed_rad_s = data->qvel[0];
  if (callback.region == nullptr) {
    data->ctrl[0] = clip(callback.table, speed_rad_s, callback.wanted_Nm);
    return;
  }
  const JointRange range = callback.region->at(speed_rad_s);
  data->ctrl[0] = std::clamp(callback.wanted_Nm, range.least.torque_Nm, range.greatest.torque_Nm);
}

/// Sweeps all four quadrants at full torque both ways; returns the greatest deviation from the
/// region, which a second object computes.
double worst_through_callback_Nm(const Example& example) {
  const Region again(example.actuator, example.conditions);
  Simulation simulation(kBareJoint);
  mjcb_control = clip_control;
  const double end_rad_s = example.region.greatest_speed_rad_s();
  double worst_Nm = 0.0;
  for (int i = -kSpeeds; i <= kSpeeds; ++i) {
    const double speed_rad_s = end_rad_s * i / kSpeeds;
    const JointRange range = again.at(speed_rad_s);
    if (range.is_empty) continue;
    const auto deviation_Nm = [&](double wanted_Nm, double expected_Nm) {
      callback.wanted_Nm = wanted_Nm;
      return std::abs(simulation.force_Nm(speed_rad_s, 0.0) - expected_Nm);
    };
    const double inside_Nm = 0.5 * (range.least.torque_Nm + range.greatest.torque_Nm);
    worst_Nm =
        std::max({worst_Nm, deviation_Nm(1e6, range.greatest.torque_Nm),
                  deviation_Nm(-1e6, range.least.torque_Nm), deviation_Nm(inside_Nm, inside_Nm)});
  }
  mjcb_control = nullptr;
  return worst_Nm;
}

/// Friction, saturation, a sagging battery, field weakening: everything that no simulator's own law
/// takes.
std::vector<Actuator> actuators_with_effects() {
  Actuator weakened = lossy_knee();
  weakened.motor.pole_pairs = 21.0;
  weakened.motor.inductance_d_H = weakened.motor.inductance_q_H = 1e-4;
  weakened.drive.field_weakening = true;
  Actuator sagging = lossy_knee();
  sagging.battery = Battery{};
  sagging.battery->cell_open_circuit = {{1.0, 67.2}};
  sagging.battery->cell_resistance_ohm = 0.06;
  return {lossy_knee(), weakened, sagging};
}

// Oracle: the region at that speed. The callback asks the region itself at every step.
TEST(Mujoco, DeliversTheExactRegionWithEffectsThroughTheControlCallback) {
  for (const Actuator& actuator : actuators_with_effects()) {
    const Example example(actuator);
    callback = {&example.region, {}, 0.0};
    const double share = worst_through_callback_Nm(example) / example.table.peak_torque_Nm;
    std::printf("region with effects, by callback: %.3g of the peak torque\n", share);
    EXPECT_LE(share, kOfPeak);
  }
}

// Oracle: the region at that speed. clip.hpp needs no more than a table that is fine enough; its
// probes may miss the worst point by a little, hence half of what is to be kept.
TEST(Mujoco, DeliversTheRegionWithEffectsThroughATableAsFineAsAskedFor) {
  for (const Actuator& actuator : actuators_with_effects()) {
    const Example example(actuator);
    for (const double accuracy : {kTableAccuracy, 0.5 * kOfPeak}) {
      const MorTable rows = mor_table(example.region, accuracy);
      const ClipTable table(rows);
      callback = {nullptr, table.view(), 0.0};
      const double share = worst_through_callback_Nm(example) / example.table.peak_torque_Nm;
      std::printf("region with effects, by a table of %zu rows: %.3g of the peak torque\n",
                  rows.rows.size(), share);
      EXPECT_LE(share, 2.0 * accuracy);
      EXPECT_LE(rows.interpolation_error_Nm, accuracy * rows.peak_torque_Nm);
    }
  }
}

// Held at full voltage and let go, the joint ends at the no-load speed 67.2 / (20 0.32).
TEST(Mujoco, RunsUpToTheNoLoadSpeed) {
  Simulation simulation(exported(Example(knee()), LawFit::kConservative));
  simulation.model->opt.timestep = 1e-4;
  simulation.data->ctrl[0] = 67.2;
  for (int i = 0; i < 2000; ++i) mj_step(simulation.model.get(), simulation.data.get());
  EXPECT_NEAR(simulation.data->qvel[0], 10.5, 1e-6);
}

}  // namespace
}  // namespace torquewright::actuator
