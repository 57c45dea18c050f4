// SPDX-License-Identifier: Apache-2.0
// Oracle: the law that was put in. Beside a size of zero a law's shape has no slope at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "identification/forward/torque_forward.hpp"
#include "identification/preparation/held_signals.hpp"
#include "identification/selection/folds.hpp"
#include "identification/selection/model_fit.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::fit_from_zero_test {
namespace {

using made::Made;
using made::MadeBench;

TEST(FitFromZero, FindsTheShapeOfALaw) {
  const MadeBench made;
  const Log log = made.log([](const Made& at) {
    return -0.3 * std::pow(std::abs(at.speed_rad_s), 0.6) * made::sign(at.speed_rad_s);
  });
  const Bench bench = made.bench(log);
  const HeldSignals held = held_signals(log, bench, noise_levels(log, 0), 1);
  const ForwardEquation equation = torque_forward(bench, held.rows, run_folds(log));
  const Rows rows(held.rows, run_folds(log), {});
  const ModelFitter fitter(equation, rows, held.replica);
  const auto power =
      std::find_if(equation.candidates.begin(), equation.candidates.end(),
                   [](const EffectCandidate& each) { return each.effect == "power_law_drag"; });
  ASSERT_NE(power, equation.candidates.end());
  for (const double exponent : {0.3, 0.9, 1.5}) {
    Eigen::VectorXd start(fitter.always_start().size() + 2);
    start << fitter.always_start(), 0.0, exponent;
    const ModelFit fit = fitter.fit({&*power}, start);
    EXPECT_NEAR(fit.coordinates[fit.always], 0.3, 0.003) << exponent;
    EXPECT_NEAR(fit.coordinates[fit.always + 1], 0.6, 0.006) << exponent;
  }
}

}  // namespace
}  // namespace torquewright::identification::fit_from_zero_test
