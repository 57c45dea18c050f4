// SPDX-License-Identifier: Apache-2.0
// Oracle: MuJoCo itself, the version of the system's package, which reads our files.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "actuator/clip_table.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kOfPeak = 1e-6;  // the gains are printed so that they read back the same
constexpr int kSpeeds = 1000;

struct Deleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// One hinge and one actuator, at rest.
struct Simulation {
  explicit Simulation(const std::string& text) {
    const test::ScratchFolder folder;
    std::array<char, 1000> error{};
    const std::string file = folder.write("model.xml", text).string();
    model.reset(mj_loadXML(file.c_str(), nullptr, error.data(), error.size()));
    if (!model) throw std::runtime_error(error.data());
    data.reset(mj_makeData(model.get()));
  }

  double force_Nm(double speed_rad_s, double control) {
    data->qvel[0] = speed_rad_s;
    data->ctrl[0] = control;
    mj_forward(model.get(), data.get());
    return data->qfrc_actuator[0];
  }

  std::unique_ptr<mjModel, Deleter> model;
  std::unique_ptr<mjData, Deleter> data;
};

std::string exported(const Example& example, Fit fit) {
  const Subject subject = example.subject(fit);
  const Shape shape = exporters::mujoco.shape(subject);
  return exporters::mujoco.write(subject, shape, {"a note -- with -- hyphens"});
}

TEST(Mujoco, ReadsTheFileAsItWasMeant) {
  const Example example(knee());
  const Simulation simulation(exported(example, Fit::kConservative));
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
  Simulation simulation(exported(example, Fit::kConservative));
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

// More voltage than there is, is not to be had.
TEST(Mujoco, ClampsTheVoltage) {
  Simulation simulation(exported(Example(knee()), Fit::kConservative));
  EXPECT_EQ(simulation.force_Nm(9.0, 1000.0), simulation.force_Nm(9.0, 67.2));
  EXPECT_NEAR(simulation.force_Nm(0.0, 7.0), 160.0, 1e-9);  // 1536 Nm per 67.2 V
}

TEST(Mujoco, DoesWhatTheLawSaysWhereTheRegionIsNone) {
  const Example example(lossy_knee());
  for (const Fit fit : {Fit::kConservative, Fit::kBest}) {
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

/// What MuJoCo's callback, which is one for the whole process, clips with and to.
struct Callback {
  TableView table;
  double wanted_Nm = 0.0;
};
Callback callback;

void clip_control(const mjModel* /*model*/, mjData* data) {
  data->ctrl[0] = clip(callback.table, data->qvel[0], callback.wanted_Nm);
}

// The exact region with friction and saturation, by clip.hpp in the control callback.
TEST(Mujoco, DeliversTheRegionWithEffectsThroughTheControlCallback) {
  const Example example(lossy_knee());
  const ClipTable table(example.table);
  Simulation simulation(R"(<mujoco><worldbody><body>
      <joint name="joint" type="hinge" axis="0 0 1"/><geom size="0.05" mass="1"/>
    </body></worldbody><actuator><motor joint="joint"/></actuator></mujoco>)");
  callback.table = table.view();
  mjcb_control = clip_control;
  const double end_rad_s = example.region.greatest_speed_rad_s();
  double worst_Nm = 0.0;
  for (int i = -kSpeeds; i <= kSpeeds; ++i) {
    const double speed_rad_s = end_rad_s * i / kSpeeds;
    const JointRange range = example.region.at(speed_rad_s);
    callback.wanted_Nm = 1e6;
    worst_Nm = std::max(worst_Nm,
                        std::abs(simulation.force_Nm(speed_rad_s, 0.0) - range.greatest.torque_Nm));
    callback.wanted_Nm = -1e6;
    worst_Nm =
        std::max(worst_Nm, std::abs(simulation.force_Nm(speed_rad_s, 0.0) - range.least.torque_Nm));
    callback.wanted_Nm = 0.5 * (range.least.torque_Nm + range.greatest.torque_Nm);
    EXPECT_NEAR(simulation.force_Nm(speed_rad_s, 0.0), callback.wanted_Nm,
                1e-3 * example.table.peak_torque_Nm);
  }
  mjcb_control = nullptr;
  std::printf("with effects: worst deviation %.3g Nm, table's own error %.3g Nm\n", worst_Nm,
              example.table.interpolation_error_Nm);
  // The table's probes may miss its worst point by a little.
  EXPECT_LE(worst_Nm, 1.2 * example.table.interpolation_error_Nm);
  EXPECT_GT(worst_Nm, 0.0);
}

// Held at full voltage and let go, the joint ends at the no-load speed 67.2 / (20 0.32).
TEST(Mujoco, RunsUpToTheNoLoadSpeed) {
  Simulation simulation(exported(Example(knee()), Fit::kConservative));
  simulation.model->opt.timestep = 1e-4;
  simulation.data->ctrl[0] = 67.2;
  for (int i = 0; i < 2000; ++i) mj_step(simulation.model.get(), simulation.data.get());
  EXPECT_NEAR(simulation.data->qvel[0], 10.5, 1e-6);
}

}  // namespace
}  // namespace torquewright::actuator
