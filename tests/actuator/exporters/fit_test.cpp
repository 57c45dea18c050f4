// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "actuator/exporters/downhill_simplex.hpp"
#include "actuator/exporters/error_report.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/library.hpp"
#include "actuator/exporters/line_law.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"

namespace torquewright::actuator {
namespace {

const Exporter* const kLines[] = {&exporters::mujoco,    &exporters::mujoco_dcmotor,
                                  &exporters::isaac_lab, &exporters::mjlab,
                                  &exporters::newton,    &exporters::raisim2};

// Oracle: Rosenbrock's valley, whose least value is 0 at (1, 1).
TEST(Downhill, FindsTheEndOfRosenbrocksValley) {
  const auto valley = [](const std::vector<double>& at) {
    return 100.0 * std::pow(at[1] - at[0] * at[0], 2.0) + std::pow(1.0 - at[0], 2.0);
  };
  const std::vector<double> end = downhill(valley, {-1.2, 1.1}, 0.1, 1e-14, 5000);
  EXPECT_NEAR(end[0], 1.0, 1e-5);
  EXPECT_NEAR(end[1], 1.0, 1e-5);
}

// Oracle: closed forms of the lossless knee, in example_actuators.hpp.
TEST(LawFit, OfALosslessActuatorIsItsParallelogram) {
  const Example example(knee());
  for (const LawFit fit : {LawFit::kConservative, LawFit::kBest}) {
    for (const Exporter* exporter : kLines) {
      const Shape shape = exporter->shape(example.subject(fit));
      EXPECT_NEAR(shape[0], 1536.0, 1e-9);
      EXPECT_NEAR(shape[1], 10.5, 1e-12);
      EXPECT_NEAR(shape[2], 320.0, 1e-9);
    }
  }
}

TEST(LawFit, OnTheMotorsSideIsTheRotors) {
  const Example example(knee(), Side::kMotor);
  const Shape shape = exporters::isaac_lab.shape(example.subject(LawFit::kBest));
  EXPECT_NEAR(shape[0], 76.8, 1e-10);
  EXPECT_NEAR(shape[1], 210.0, 1e-10);
  EXPECT_NEAR(shape[2], 16.0, 1e-10);
  EXPECT_NEAR(example.subject(LawFit::kBest).armature_kg_m2(), 0.000922, 1e-15);
}

/// The greatest part of the law outside the region, where that holds zero torque: at speeds that
/// the fit does not look at.
double greatest_excess_Nm(const Example& example, const Exporter& exporter, const Shape& shape) {
  double excess_Nm = 0.0;
  std::mt19937 dice(3);
  const double end_rad_s = example.region.greatest_speed_rad_s();
  std::uniform_real_distribution<double> speed(-end_rad_s, end_rad_s);
  for (int i = 0; i < 3000; ++i) {
    const double speed_rad_s = speed(dice);
    const JointRange range = example.region.at(speed_rad_s);
    if (range.is_empty || range.least.torque_Nm > 0.0 || range.greatest.torque_Nm < 0.0) continue;
    const TorqueLimits at = exporter.law(shape, speed_rad_s);
    if (std::isinf(at.greatest_Nm)) continue;
    excess_Nm = std::max({excess_Nm, at.greatest_Nm - range.greatest.torque_Nm,
                          range.least.torque_Nm - at.least_Nm});
  }
  return excess_Nm;
}

/// Of both bounds; of a law that derates braking only of driving, which its fit serves.
double mean_square_Nm2(const Example& example, const Exporter& exporter, const Shape& shape) {
  double sum = 0.0;
  const double end_rad_s = example.region.greatest_speed_rad_s();
  constexpr int kCount = 1000;
  for (int i = 0; i < kCount; ++i) {
    const double speed_rad_s = end_rad_s * (2.0 * (i + 0.5) / kCount - 1.0);
    const JointRange range = example.region.at(speed_rad_s);
    const TorqueLimits at = exporter.law(shape, speed_rad_s);
    const bool counts_all = !exporter.derates_braking;
    if (counts_all || speed_rad_s > 0.0) {
      sum += std::pow(at.greatest_Nm - (counts_all ? range.greatest.torque_Nm
                                                   : std::max(0.0, range.greatest.torque_Nm)),
                      2.0);
    }
    if (counts_all || speed_rad_s < 0.0) {
      sum += std::pow(
          at.least_Nm - (counts_all ? range.least.torque_Nm : std::min(0.0, range.least.torque_Nm)),
          2.0);
    }
  }
  return sum / kCount;
}

TEST(LawFit, ConservativeStaysInsideAndBestIsNearerInTheMean) {
  std::mt19937 dice(20);
  for (int i = 0; i < 4; ++i) {
    const Example example(i == 0 ? lossy_knee() : random_actuator(dice));
    // Between the speeds that the fit looks at a curved bound may bulge inward by this much.
    const double tolerance_Nm = 1e-3 * example.table.peak_torque_Nm;
    for (const Exporter* exporter : exporter_library()) {
      SCOPED_TRACE(exporter->name);
      const Shape careful = exporter->shape(example.subject(LawFit::kConservative));
      EXPECT_LE(greatest_excess_Nm(example, *exporter, careful), tolerance_Nm);
      EXPECT_TRUE(std::all_of(careful.begin(), careful.end(),
                              [](double value) { return std::isfinite(value); }));
      if (exporter->parameters.empty() || exporter == &exporters::urdf ||
          exporter == &exporters::sdf || exporter == &exporters::drake_sdf ||
          exporter == &exporters::isaac_lab_remotized) {
        continue;
      }
      const Shape best = exporter->shape(example.subject(LawFit::kBest));
      EXPECT_LT(mean_square_Nm2(example, *exporter, best),
                mean_square_Nm2(example, *exporter, careful));
      EXPECT_GT(greatest_excess_Nm(example, *exporter, best), tolerance_Nm);
    }
  }
}

// Oracle: closed form of the lossless knee, corner 8.3125 rad/s, no-load speed 10.5, cap 320 Nm:
// that plateau and its fall are the driving bound itself.
TEST(LawFit, OfALawThatDeratesBrakingServesDriving) {
  const Example example(knee());
  for (const LawFit fit : {LawFit::kConservative, LawFit::kBest}) {
    const Subject subject = example.subject(fit);
    for (const Exporter* exporter :
         {&exporters::unitree_xy, &exporters::jaxsim, &exporters::physx}) {
      SCOPED_TRACE(exporter->name);
      const Shape shape = exporter->shape(subject);
      double sum_Nm2 = 0.0;
      for (int i = 1; i <= 1000; ++i) {
        const double speed_rad_s = 12.6875 * i / 1000;
        const double driving_Nm = std::clamp(1536.0 * (1.0 - speed_rad_s / 10.5), 0.0, 320.0);
        const double error_Nm = exporter->law(shape, speed_rad_s).greatest_Nm - driving_Nm;
        if (fit == LawFit::kConservative) {
          EXPECT_NEAR(error_Nm, 0.0, 1e-6);
        }
        sum_Nm2 += error_Nm * error_Nm;
      }
      // The right answer's cost is that of braking alone, at most its weight of 1e-3 times the peak
      // squared; no better answer has more of driving.
      EXPECT_LE(sum_Nm2 / 1000, 1e-3 * 320.0 * 320.0);
      EXPECT_EQ(exporter->law(shape, 10.5 * (1.0 + 1e-9)).greatest_Nm, 0.0);
    }
  }
}

// The region drives less far with friction than its voltage says.
TEST(LawFit, NeverPassesTheNoLoadSpeed) {
  std::mt19937 dice(21);
  for (int i = 0; i < 4; ++i) {
    const Example example(i == 0 ? lossy_knee() : random_actuator(dice));
    for (const LawFit fit : {LawFit::kConservative, LawFit::kBest}) {
      for (const Exporter* exporter :
           {&exporters::unitree_xy, &exporters::jaxsim, &exporters::physx}) {
        SCOPED_TRACE(exporter->name);
        const Shape shape = exporter->shape(example.subject(fit));
        for (const MorRow& row : example.table.rows) {
          const bool drives =
              !row.range.is_empty && (row.speed_rad_s > 0.0 ? row.range.greatest.torque_Nm > 0.0
                                                            : row.range.least.torque_Nm < 0.0);
          if (drives || row.speed_rad_s == 0.0) continue;
          const TorqueLimits at = exporter->law(shape, row.speed_rad_s);
          const double driving_Nm = row.speed_rad_s > 0.0 ? at.greatest_Nm : -at.least_Nm;
          EXPECT_LE(driving_Nm, 1e-6 * example.table.peak_torque_Nm) << row.speed_rad_s;
        }
      }
    }
  }
}

// Oracle: closed form. 100 Nm s/rad end the driving at 1536 / (1536/10.5 + 100) = 6.24 rad/s,
// before the voltage's corner of 8.3125: the law's own knee lies before that end too.
TEST(LawFit, KeepsItsKneeBeforeWhereFrictionEndsTheDriving) {
  Actuator actuator = knee();
  actuator.effects.push_back({find_effect("viscous_friction"), {100.0}, {}, false, ""});
  const Example example(std::move(actuator));
  for (const LawFit fit : {LawFit::kConservative, LawFit::kBest}) {
    for (const Exporter* exporter : {&exporters::unitree_xy, &exporters::jaxsim}) {
      SCOPED_TRACE(exporter->name);
      const Shape shape = exporter->shape(example.subject(fit));
      EXPECT_GT(exporter->law(shape, 0.0).greatest_Nm, 0.0);
      EXPECT_EQ(exporter->law(shape, 6.24).greatest_Nm, 0.0);
      for (const double speed_rad_s : {0.5, 2.0, 4.0, 6.0}) {
        const double driving_Nm =
            std::min(320.0, 1536.0 * (1.0 - speed_rad_s / 10.5)) - 100.0 * speed_rad_s;
        const double most_Nm = exporter->law(shape, speed_rad_s).greatest_Nm;
        if (fit == LawFit::kConservative) {
          EXPECT_LE(most_Nm, std::max(0.0, driving_Nm) + 1e-6) << speed_rad_s;
        }
        EXPECT_GE(most_Nm, 0.5 * driving_Nm) << speed_rad_s;
      }
    }
  }
}

// Friction that holds at rest and does not drive: what it adds there is in no row of motion.
TEST(ErrorReport, RestHasRowsOfItsOwn) {
  Actuator actuator = knee();
  actuator.effects = {effect("coulomb_friction", {30.0})};
  const Example example(actuator);
  const Subject subject = example.subject(LawFit::kConservative);
  const ErrorReport report =
      error_report(subject, exporters::raisim1, exporters::raisim1.shape(subject));
  for (const QuadrantError& error : report.quadrants) {
    EXPECT_NE(error.direction, 0);
    EXPECT_LE(error.cautious.torque_Nm, 1e-3 * example.table.peak_torque_Nm);
  }
  EXPECT_EQ(report.at_rest[0].direction, 0);
  EXPECT_TRUE(report.at_rest[0].is_upper);
  EXPECT_FALSE(report.at_rest[1].is_upper);
}

// Oracle: a mirror. The laws know no direction, so that friction of one direction weighs as much as
// the same of the other; what remains is which of the speeds are looked at.
TEST(LawFit, LooksBothWays) {
  const auto shape_with = [](double forward_Nm, double backward_Nm) {
    Actuator actuator = knee();
    actuator.effects = {effect("asymmetric_friction", {forward_Nm, backward_Nm, 0.0, 0.0})};
    const Example example(actuator);
    return exporters::mujoco.shape(example.subject(LawFit::kBest));
  };
  const Shape one = shape_with(60.0, 5.0);
  const Shape other = shape_with(5.0, 60.0);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i] / other[i], 1.0, 2e-3) << i;
}

// A conservative law that is needlessly small would pass the test above.
TEST(LawFit, ConservativeIsNotSmallerThanItMustBe) {
  const Example example(lossy_knee());
  for (const Exporter* exporter : exporter_library()) {
    if (exporter->parameters.empty()) continue;
    SCOPED_TRACE(exporter->name);
    Shape shape = exporter->shape(example.subject(LawFit::kConservative));
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (exporter->parameters[i].scales == Scales::kWithRegion) shape[i] *= 1.01;
    }
    EXPECT_GT(greatest_excess_Nm(example, *exporter, shape), 1e-3 * example.table.peak_torque_Nm);
  }
}

TEST(ErrorReport, OfTheRightLawIsNone) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kConservative);
  for (const Exporter* exporter : {&exporters::mujoco, &exporters::drake, &exporters::raisim2}) {
    const ErrorReport report = error_report(subject, *exporter, exporter->shape(subject));
    for (const QuadrantError& quadrant : report.quadrants) {
      EXPECT_EQ(quadrant.optimistic.torque_Nm, 0.0);
      EXPECT_EQ(quadrant.cautious.torque_Nm, 0.0);
    }
    EXPECT_EQ(report.share_outside, 0.0);
    EXPECT_TRUE(report.sentences.empty());
  }
}

// Oracle: closed forms. The box of peak torque and no-load speed exceeds the knee's region by two
// triangles: (w0 - wc) / (4 w0) = 2.1875 / 42 of its area, and by 320 Nm at 10.5 rad/s.
TEST(ErrorReport, OfTheBoxIsTwoTriangles) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kBest);
  const ErrorReport report = error_report(subject, exporters::urdf, exporters::urdf.shape(subject));
  EXPECT_NEAR(report.share_outside, 2.1875 / 42.0, 1e-6);
  const auto& [forward_upper, forward_lower, backward_upper, backward_lower] = report.quadrants;
  EXPECT_NEAR(forward_upper.optimistic.torque_Nm, 320.0, 1e-6);
  EXPECT_NEAR(forward_upper.optimistic.speed_rad_s, 10.5, 1e-6);
  EXPECT_EQ(forward_lower.optimistic.torque_Nm, 0.0);
  EXPECT_EQ(backward_upper.optimistic.torque_Nm, 0.0);
  EXPECT_NEAR(backward_lower.optimistic.torque_Nm, 320.0, 1e-6);
  EXPECT_NEAR(backward_lower.optimistic.speed_rad_s, -10.5, 1e-6);
  ASSERT_EQ(report.sentences.size(), 2u);
  EXPECT_NE(report.sentences[0].find("> 10.5 rad/s the format sets no limit"), std::string::npos);
}

// Oracle: closed forms. A law of 100 Nm at any speed leaves the knee's region, whose bound is 1536
// (1
// - w / 10.5), from 9.8164 rad/s on and has left it at 11.1836; half of that way and the rest up to
// 12.6875 rad/s are 5/29 of it. At the end it drives with 100 Nm and need not brake with 320.
TEST(ErrorReport, OfALawWithoutAnEnd) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kBest);
  Exporter endless = exporters::urdf;
  endless.law = [](std::span<const double> shape, double) {
    return TorqueLimits{-shape[0], shape[0]};
  };
  const ErrorReport report = error_report(subject, endless, Shape{100.0, 1.0});
  EXPECT_NEAR(report.share_outside, 5.0 / 29.0, 1e-6);
  EXPECT_NEAR(report.quadrants[0].optimistic.torque_Nm, 100.0, 1e-6);
  EXPECT_NEAR(report.quadrants[1].optimistic.torque_Nm, 320.0, 1e-6);
  EXPECT_NEAR(report.quadrants[2].optimistic.torque_Nm, 320.0, 1e-6);
  EXPECT_NEAR(report.quadrants[3].optimistic.torque_Nm, 100.0, 1e-6);
}

// Oracle: closed form. A law that peaks with 400 Nm at 10/3 rad/s, none of the speeds looked at,
// exceeds the knee's 320 Nm by 80 there.
TEST(ErrorReport, FindsTheWorstSpeedBetweenThoseLookedAt) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kBest);
  Exporter peaked = exporters::urdf;
  peaked.law = [](std::span<const double>, double speed_rad_s) {
    return TorqueLimits{-320.0, 400.0 - 100.0 * std::abs(speed_rad_s - 10.0 / 3.0)};
  };
  const WorstError worst = error_report(subject, peaked, {}).quadrants[0].optimistic;
  EXPECT_NEAR(worst.torque_Nm, 80.0, 1e-6);
  EXPECT_NEAR(worst.speed_rad_s, 10.0 / 3.0, 1e-6);
}

// Oracle: closed forms. With the knee's own numbers PhysX gives no braking at the no-load speed,
// where the motor brakes with 320 Nm, and no forced braking at the overspeed, where it cannot but.
TEST(ErrorReport, OfTheSymmetricEnvelope) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kConservative);
  const ErrorReport report =
      error_report(subject, exporters::physx, Shape{320.0, 10.5, 10.5 / 1536.0});
  const QuadrantError& driving = report.quadrants[0];
  const QuadrantError& braking = report.quadrants[1];
  EXPECT_EQ(driving.optimistic.torque_Nm, 0.0);
  EXPECT_EQ(driving.cautious.torque_Nm, 0.0);
  EXPECT_NEAR(braking.optimistic.torque_Nm, 320.0, 1e-6);
  EXPECT_NEAR(braking.optimistic.speed_rad_s, 12.6875, 1e-6);
  EXPECT_NEAR(braking.cautious.torque_Nm, 320.0, 1e-6);
  EXPECT_GE(braking.cautious.speed_rad_s, 10.5 - 1e-6);
}

// The line law without a clamp on the speed, as Newton's was before commit 80c0da73a.
TEST(ErrorReport, SaysWhereALawContradictsItself) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kConservative);
  Exporter crossing = exporters::newton;
  crossing.law = [](std::span<const double> shape, double speed_rad_s) {
    return TorqueLimits{std::max(shape[0] * (-1.0 - speed_rad_s / shape[1]), -shape[2]),
                        std::min(shape[0] * (1.0 - speed_rad_s / shape[1]), shape[2])};
  };
  EXPECT_TRUE(
      error_report(subject, exporters::newton, exporters::newton.shape(subject)).sentences.empty());
  const ErrorReport right = error_report(subject, crossing, exporters::newton.shape(subject));
  ASSERT_EQ(right.sentences.size(), 2u);
  EXPECT_NE(right.sentences[0].find("> 12.6875 rad/s the law contradicts itself"),
            std::string::npos)
      << right.sentences[0];
  // A smaller motor contradicts itself inside the region; what lies past it is in no number.
  const ErrorReport small = error_report(subject, crossing, Shape{1000.0, 9.0, 200.0});
  EXPECT_NE(small.sentences[0].find("> 10.8 rad/s"), std::string::npos) << small.sentences[0];
  for (const QuadrantError& quadrant : small.quadrants) {
    EXPECT_LE(std::abs(quadrant.optimistic.speed_rad_s), 10.8 + 1e-6);
    EXPECT_LE(std::abs(quadrant.cautious.speed_rad_s), 10.8 + 1e-6);
  }
}

TEST(ErrorReport, TellsTooMuchFromTooLittle) {
  const Example example(knee());
  const Subject subject = example.subject(LawFit::kConservative);
  const ErrorReport more = error_report(subject, exporters::isaac_lab, Shape{1536.0, 10.5, 330.0});
  const ErrorReport less = error_report(subject, exporters::isaac_lab, Shape{1536.0, 10.5, 310.0});
  for (const QuadrantError& quadrant : more.quadrants) {
    EXPECT_NEAR(quadrant.optimistic.torque_Nm, 10.0, 1e-6);
  }
  for (const QuadrantError& quadrant : less.quadrants) {
    EXPECT_NEAR(quadrant.cautious.torque_Nm, 10.0, 1e-6);
  }
  EXPECT_GT(more.share_outside, 0.01);
  // Past its smaller overspeed it brakes with 310 Nm where the motor cannot do with less than 320.
  EXPECT_LT(less.share_outside, 1e-9);
}

TEST(ErrorReport, SaysThatTheRegionIsEmptySomewhere) {
  Actuator actuator = knee();
  actuator.drive.regeneration = false;
  const Example example(actuator);
  const Subject subject = example.subject(LawFit::kConservative);
  const ErrorReport report = error_report(subject, exporters::mujoco, line_start(subject));
  const bool is_said = std::any_of(
      report.sentences.begin(), report.sentences.end(), [](const std::string& sentence) {
        return sentence.find("the region is empty") != std::string::npos;
      });
  const bool has_empty_row = std::any_of(example.table.rows.begin(), example.table.rows.end(),
                                         [](const MorRow& row) { return row.range.is_empty; });
  EXPECT_EQ(is_said, has_empty_row);
}

}  // namespace
}  // namespace torquewright::actuator
