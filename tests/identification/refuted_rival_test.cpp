// SPDX-License-Identifier: Apache-2.0
// What a model leaves of runs that no fit saw. Oracle: by hand.
#include <gtest/gtest.h>

#include "actuator/motor/actuator.hpp"
#include "identification/forward/torque_forward.hpp"
#include "identification/preparation/held_signals.hpp"
#include "identification/selection/folds.hpp"
#include "identification/selection/search.hpp"
#include "tests/identification/made_bench.hpp"

namespace torquewright::identification::refuted_rival_test {
namespace {

using made::Made;
using made::MadeBench;

// A rival that leaves as much of the fitted runs, and of those that no fit saw 1.3 times the rms
// where the best leaves noise in them, 3 times where it does not; just within and just beyond.
TEST(RefutedRival, LeavesMoreOfTheRunsThatNoFitSaw) {
  const MadeBench made;
  // A spring that nothing states: 0.5 Nm, and noise of 0.01.
  for (const double stiffness_Nm_rad : {0.0, 0.2}) {
    const double most = stiffness_Nm_rad > 0.0 ? 3.0 : 1.3;
    const Log log = made.log([=](const Made& at) { return -stiffness_Nm_rad * at.angle_rad; });
    const Bench bench = made.bench(log);
    const HeldSignals held = held_signals(log, bench, noise_levels(log, 0), 1);
    const ForwardEquation equation = torque_forward(bench, held.rows, run_folds(log));
    const Rows rows(held.rows, run_folds(log), {});
    const ModelFitter fitter(equation, rows, held.replica);
    const Search search(fitter, {});
    const ModelFit best = fitter.fit({}, fitter.always_start());
    for (const double times : {0.98 * most, 1.02 * most}) {
      ModelFit rival = best;
      for (std::size_t b = 0; b < rows.blocks().size(); ++b) {
        if (!rows.blocks()[b].is_held_out()) continue;
        const double noise = best.sums[b].noise;
        rival.unseen[b] = times * times * (best.unseen[b] + noise) - noise;
      }
      EXPECT_EQ(search.is_refuted(rival, best), times > most) << times;
    }
  }
}

}  // namespace
}  // namespace torquewright::identification::refuted_rival_test
