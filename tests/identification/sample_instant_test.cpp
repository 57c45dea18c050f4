// SPDX-License-Identifier: Apache-2.0
// Oracle: logs by closed form in which the drive's channel was read within its step, which shows at
// two jumps of a run and nowhere else: too few parts for a fit to be sure of it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "actuator/motor/actuator.hpp"
#include "identification/answer/analysis.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::sample_instant_test {
namespace {

using made::MadeBench;

constexpr double kLevel_Nm = 0.03, kSigma_Nm = 0.01, kErrors = 3.0;

/// There and back, each within some steps of the log.
double jumping_current_A(std::size_t run, double t) {
  constexpr double kWithin_s = 0.01;
  const double since_s = t - 3.0 - 0.7 * static_cast<double>(run);
  const double back = std::tanh(since_s / kWithin_s) - std::tanh((since_s - 4.1) / kWithin_s);
  return 3.0 * (1.0 - back) + 0.5 * std::sin(0.6 * t);
}

/// Coulomb friction by a sensor that is late by less than half a step of 5 ms.
Log with_jumps(const MadeBench& made, double late_s) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0.0, kSigma_Nm);
  Log log = made.log([](const made::Made&) { return 0.0; });
  for (std::size_t r = 0; r < log.runs.size(); ++r) {
    log.runs.change(r, [&](Run& run) {
      for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const double t = run.time_s[k], seen = t - late_s;
        run.joints[0][Quantity::kMotorCurrent][k] = jumping_current_A(r, t);
        run.joints[0][Quantity::kOutputTorque][k] =
            MadeBench::kRatio * MadeBench::kTorqueConstant_Nm_A * jumping_current_A(r, seen) -
            kLevel_Nm * made::sign(MadeBench::speed_rad_s(r, seen)) + noise(random);
      }
    });
  }
  return log;
}

TEST(SampleInstant, ThatShowsAtFewJumpsHidesNoFriction) {
  const MadeBench made;
  for (const double late_s : {0.0, 2e-3}) {
    const Log log = with_jumps(made, late_s);
    const EquationResult found = analyse(made.rig, log, 0, {&made.actuator}, {}).front();
    EXPECT_EQ(found.verdict, Verdict::kExplained) << late_s;
    ASSERT_EQ(found.added.size(), 1u) << late_s;
    EXPECT_EQ(found.added[0].effect, "coulomb_friction");
    EXPECT_TRUE(is_certain(found, "coulomb_friction"));
    const FoundParameters& values = found.added[0].parameters;
    EXPECT_NEAR(values.value("coulomb_Nm", NAN), kLevel_Nm,
                kErrors * values.standard_error("coulomb_Nm"));
  }
}

}  // namespace
}  // namespace torquewright::identification::sample_instant_test
