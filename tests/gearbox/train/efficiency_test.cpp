// SPDX-License-Identifier: Apache-2.0
#include "gearbox/train/efficiency.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "gearbox/train/power_flow.hpp"
#include "tests/gearbox/train/random_trains.hpp"

namespace torquewright::gearbox {
namespace {

/// The short form of Lambda, which published tables use also where an end exceeds 1.
double short_loss_factor(const ContactPath<double>& path) {
  return path.approach * path.approach + path.recess * path.recess - path.approach - path.recess +
         1.0;
}

ThreeKMeshEfficiencies<double> short_meshes(const ThreeKTeeth<double>& z, double friction) {
  const double scale = friction * std::numbers::pi;
  return {1 - scale * (1 / z.sun + 1 / z.planet_1) *
                  short_loss_factor(external_path(z.sun, z.planet_1)),
          1 - scale * (1 / z.planet_1 - 1 / z.fixed_ring) *
                  short_loss_factor(internal_path(z.planet_1, z.fixed_ring)),
          1 - scale * (1 / z.planet_2 - 1 / z.output_ring) *
                  short_loss_factor(internal_path(z.planet_2, z.output_ring))};
}

TrainEfficiency efficiency_of(const ThreeKTeeth<double>& teeth,
                              const ThreeKMeshEfficiencies<double>& mesh) {
  return three_k_efficiency(basic_ratio_1(teeth), basic_ratio_2(teeth), mesh);
}

TEST(ThreeKEfficiency, MeetsCompactsTableWithTheShortLossFactor) {
  // COMPAct's published table, mu = 0.3, zero shift. Its tooth geometry is not printed; the
  // reference claims agreement within 1e-3.
  struct Row {
    ThreeKTeeth<double> teeth;
    double published;
    double here;      ///< To four digits, with the short form.
    double backward;  ///< To three digits.
  };
  const std::vector<Row> rows{
      {{64, 48, 28, 160, 140}, .905, .9047, .897}, {{72, 42, 30, 156, 144}, .861, .8603, .841},
      {{63, 35, 28, 133, 126}, .787, .7870, .736}, {{54, 36, 30, 126, 120}, .759, .7585, .691},
      {{28, 40, 32, 108, 100}, .791, .7907, .749}, {{36, 32, 28, 100, 96}, .672, .6721, .534},
      {{60, 48, 44, 156, 152}, .682, .6814, .547}};
  for (const Row& row : rows) {
    const TrainEfficiency result = efficiency_of(row.teeth, short_meshes(row.teeth, 0.3));
    EXPECT_NEAR(result.forward, row.published, 1e-3) << row.teeth.sun;
    EXPECT_NEAR(result.forward, row.here, 5.001e-5) << row.teeth.sun;
    EXPECT_NEAR(result.backward, row.backward, 5.001e-4) << row.teeth.sun;
  }
}

TEST(ThreeKEfficiency, GeneralLossFactorIsBetterThanTheShortOneSays) {
  const ThreeKTeeth<double> teeth{36, 32, 28, 100, 96};  // reference section 12: .6737/.5372
  const TrainEfficiency result = efficiency_of(teeth, mesh_efficiencies(teeth, 0.3));
  EXPECT_NEAR(result.forward, .6737, 5e-5);
  EXPECT_NEAR(result.backward, .5372, 5e-5);
}

TEST(ThreeKEfficiency, OfD151) {
  // Reference section 12; the table uses the short form, the last line the general one.
  const ThreeKTeeth<double> teeth{44, 44, 32, 132, 120};
  const auto mesh = short_meshes(teeth, 0.05);
  EXPECT_NEAR(mesh.sun_planet_1, .99452, 5e-6);
  EXPECT_NEAR(mesh.planet_1_fixed_ring, .99776, 5e-6);
  EXPECT_NEAR(mesh.planet_2_output_ring, .99666, 5e-6);
  struct Row {
    double friction, forward, backward;
  };
  for (const Row& row : {Row{.05, .97251, .97189}, Row{.08, .95662, .95505},
                         Row{.10, .94626, .94384}, Row{.15, .92118, .91587}}) {
    const TrainEfficiency result = efficiency_of(teeth, short_meshes(teeth, row.friction));
    EXPECT_NEAR(result.forward, row.forward, 5.001e-6);
    EXPECT_NEAR(result.backward, row.backward, 5.001e-6);
  }
  const TrainEfficiency general = efficiency_of(teeth, mesh_efficiencies(teeth, 0.08));
  EXPECT_NEAR(general.forward, .9568, 5e-5);
  EXPECT_NEAR(general.backward, .9552, 5e-5);
}

TEST(ThreeKEfficiency, OfMatsukiWithItsPublishedMeshes) {
  // Reference section 12, mu = .10; the mesh values are rounded to 5e-6 and the ring meshes weigh
  // 10.3, so the train's value is known to 5e-6 (0.9 + 2 * 10.3 + 1) < 1.2e-4.
  const ThreeKTeeth<double> teeth{12, 39, 32, 90, 81};
  const TrainEfficiency result = efficiency_of(teeth, {.98179, .99741, .99605});
  EXPECT_NEAR(result.forward, .91975, 1.2e-4);
  EXPECT_NEAR(result.backward, .91511, 1.2e-4);
}

TEST(ThreeKEfficiency, OfTheSplitRing) {
  // Tuplin 1957 in an example of Simscape Driveline: 256:1, 0.22; reference: .2194 with two meshes
  // of 0.993. Carrier input without sun: eta = 1/(R (1 - eta0) + eta0). A sun of I1 -> infinity
  // with lossless meshes is the same train.
  const double ratio_2 = 1.0 - 1.0 / 256.0;
  const double huge = 1e12;
  const TrainEfficiency result = three_k_efficiency(huge, ratio_2, {1.0, .993, .993});
  const double both = .993 * .993;
  // the sun mesh in series costs eta_b once more in the limit: take it out
  EXPECT_NEAR(result.forward / .993, 1.0 / (256.0 * (1 - both) + both), 1e-9);
  EXPECT_NEAR(1.0 / (256.0 * (1 - both) + both), .2194, 5e-5);
}

/// Oracle: all eight sign patterns of the rolling powers, each a linear equation for the output
/// torque; consistent ones with an efficiency in (0, 1] survive (the energy filter).
std::vector<double> pattern_search(double ratio_1, double ratio_2,
                                   const ThreeKMeshEfficiencies<double>& mesh, bool forward) {
  std::vector<double> found;
  const double direction = forward ? 1.0 : -1.0;  // of the sun's torque; the carrier turns with +1
  for (int pattern = 0; pattern < 8; ++pattern) {
    const auto factor = [&](int bit, double efficiency) {
      return (pattern >> bit) & 1 ? efficiency : 1.0 / efficiency;
    };
    const double a = factor(0, mesh.sun_planet_1);
    const double b = factor(1, mesh.planet_1_fixed_ring);
    const double c = factor(2, mesh.planet_2_output_ring);
    // T_S I1 a - T_F b - T_O I2 c = 0 with T_F = -T_S - T_O
    const double sun = direction;
    const double output = -sun * (ratio_1 * a + b) / (b - ratio_2 * c);
    const double powers[3] = {sun * ratio_1, sun + output, -output * ratio_2};
    bool consistent = std::isfinite(output);
    for (int bit = 0; bit < 3; ++bit) {
      consistent = consistent && (powers[bit] > 0) == (((pattern >> bit) & 1) == 1);
    }
    const double sun_power = sun * (1 + ratio_1);
    const double output_power = output * (1 - ratio_2);
    const double efficiency = forward ? -output_power / sun_power : -sun_power / output_power;
    if (consistent && efficiency > 0 && efficiency <= 1) found.push_back(efficiency);
  }
  return found;
}

TEST(ThreeKEfficiency, AgreesWithTheSearchOverPowerFlows) {
  test::RandomTrains trains(5);
  int locking = 0;
  for (int trial = 0; trial < 50000; ++trial) {
    const auto [first, second, mesh] = trains.next();
    const TrainEfficiency closed = three_k_efficiency(first, second, mesh);
    const auto forward = pattern_search(first, second, mesh, true);
    const auto backward = pattern_search(first, second, mesh, false);
    ASSERT_EQ(forward.size(), 1u) << first << " " << second;
    EXPECT_NEAR(closed.forward, forward[0], 1e-11);  // division by |1 - I2| >= 1e-3
    if (closed.flow == PowerFlow::kSelfLocking) {
      ++locking;
      EXPECT_EQ(closed.backward, 0.0);
      EXPECT_TRUE(backward.empty());
    } else {
      ASSERT_EQ(backward.size(), 1u);
      EXPECT_NEAR(closed.backward, backward[0], 1e-10);
    }
  }
  EXPECT_GT(locking, 500);
}

TEST(ThreeKEfficiency, LockingTurnsWhereTheMeshesMeetTheRatio) {
  const ThreeKMeshEfficiencies<double> mesh{0.99, 0.98, 0.97};
  const double limit = 0.98 * 0.97;
  EXPECT_EQ(three_k_efficiency(3, limit - 1e-9, mesh).flow, PowerFlow::kRuns);
  EXPECT_EQ(three_k_efficiency(3, limit + 1e-9, mesh).flow, PowerFlow::kSelfLocking);
  EXPECT_EQ(three_k_efficiency(3, 1 / limit - 1e-9, mesh).flow, PowerFlow::kSelfLocking);
  EXPECT_EQ(three_k_efficiency(3, 1 / limit + 1e-9, mesh).flow, PowerFlow::kRuns);
  EXPECT_EQ(three_k_efficiency(3, 1.0, mesh).flow, PowerFlow::kStandsStill);
  EXPECT_EQ(three_k_efficiency(3, 0.5, {0.0, 1.0, 1.0}).flow, PowerFlow::kNoMesh);
  EXPECT_EQ(three_k_efficiency(3, 0.5, {1.0, 1.0, 1.0}).forward, 1.0);
}

TEST(LossWeights, AreThePublishedOnesAndTheSlopesOfTheEfficiency) {
  const LossWeights knee = three_k_loss_weights(3.0, 0.8);  // D151: I1 = 3, I2 = .8
  EXPECT_NEAR(knee.sun_planet_1, 0.75, 1e-12);
  EXPECT_NEAR(knee.planet_2_output_ring, 4.0, 1e-12);
  const LossWeights matsuki = three_k_loss_weights(90. / 12, 90. * 32 / (39. * 81));
  EXPECT_NEAR(matsuki.sun_planet_1, .88, 5e-3);
  EXPECT_NEAR(matsuki.planet_2_output_ring, 10.3, 5e-2);
  // Oracle: one-sided difference with h = sqrt(machine epsilon); error of order weight^2 h.
  const double step = 1.5e-8;
  for (const double ratio_2 : {0.3, 0.8, 1.3, 3.0}) {
    const LossWeights weights = three_k_loss_weights(2.5, ratio_2);
    const auto slope = [&](double a, double b, double c) {
      return (1 - three_k_efficiency(2.5, ratio_2, {1 - a, 1 - b, 1 - c}).forward) / step;
    };
    EXPECT_NEAR(slope(step, 0, 0), weights.sun_planet_1, 2e-6);
    EXPECT_NEAR(slope(0, step, 0), weights.planet_1_fixed_ring, 2e-6);
    EXPECT_NEAR(slope(0, 0, step), weights.planet_2_output_ring, 2e-6);
  }
}

TEST(PlanetaryEfficiency, MeetsCompactsStage) {
  // COMPAct: 25/65/155, mu = .3: .960 published, .9595 in the reference (short form).
  const auto loss = [](double curvature, const ContactPath<double>& path) {
    return 1 - 0.3 * std::numbers::pi * curvature * short_loss_factor(path);
  };
  const PlanetaryMeshEfficiencies<double> mesh{loss(1. / 25 + 1. / 65, external_path(25., 65.)),
                                               loss(1. / 65 - 1. / 155, internal_path(65., 155.))};
  EXPECT_NEAR(planetary_efficiency(155. / 25, mesh).forward, .960, 1e-3);
  EXPECT_NEAR(planetary_efficiency(155. / 25, mesh).forward, .9595, 5e-5);
}

TEST(PlanetaryEfficiency, BackwardFollowsFromTheRollingPower) {
  // Oracle: carrier driving, the sun's mesh pair passes eta T_R = T_S I or the reverse: with the
  // sun delivering T_S w_S, the ring torque is T_S I/eta, the carrier pays T_S (1 + I/eta) w_C.
  const double ratio = 4.0;
  const double both = 0.97 * 0.98;
  const double carrier_power = (1.0 + ratio / both) / (1.0 + ratio);
  EXPECT_NEAR(planetary_efficiency(ratio, {0.97, 0.98}).backward, 1.0 / carrier_power, 1e-14);
}

}  // namespace
}  // namespace torquewright::gearbox
